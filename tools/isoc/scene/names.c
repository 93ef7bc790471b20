#include "tools/isoc/scene/names.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "tools/isoc/base/embedded.h"

void listing_add(source *s, listing *l, name n)
{
    if (n.text != NULL) {
        ADD_TO(s->memory, l->names, l->count, l->room, n);
    }
}

static int by_text(const void *left, const void *right)
{
    const name *a = left, *b = right;
    const int order = strcasecmp(a->text, b->text);
    return order != 0 ? order : a->at < b->at ? -1 : a->at > b->at;
}

/* Whether a problem has been noted at this place: the components of a name that is used twice need no further message.
 */
static bool is_told(const source *s, place at)
{
    for (size_t i = 0; i < s->problem_count; i++) {
        if (s->problems[i].at == at) {
            return true;
        }
    }
    return false;
}

void listing_check(source *s, listing *l)
{
    if (l->count > 1) {
        qsort(l->names, l->count, sizeof *l->names, by_text);
    }
    for (size_t i = 1; i < l->count; i++) {
        const name *first = &l->names[i - 1], *again = &l->names[i];
        if (first->at == again->at || is_told(s, again->at)) {
            continue;
        }
        if (strcmp(first->text, again->text) == 0) {
            source_problem(s, again->at, "the name '%s' is already used in %s", again->text, source_line(s, first->at));
        } else if (strcasecmp(first->text, again->text) == 0) {
            source_problem(s, again->at, "the name '%s' differs from '%s' in %s only in case", again->text, first->text,
                           source_line(s, first->at));
        }
    }
}

/* Things of one sort: structs that begin with their name. */
typedef struct group {
    const void *things;
    size_t count, size;
} group;

static name name_at(group g, size_t i)
{
    name n;
    memcpy(&n, (const char *)g.things + i * g.size, sizeof n);
    return n;
}

int index_called(const void *things, size_t count, size_t size, const char *called)
{
    const group g = {things, count, size};
    for (size_t i = 0; i < count && called != NULL; i++) {
        const name other = name_at(g, i);
        if (other.text != NULL && strcmp(other.text, called) == 0) {
            return (int)i;
        }
    }
    return -1;
}

static int find_among(group g, name n)
{
    return index_called(g.things, g.count, g.size, n.text);
}

#define GROUP(list) ((group){(list).all, (list).count, sizeof *(list).all})

static void list_group(source *s, listing *l, group g)
{
    for (size_t i = 0; i < g.count; i++) {
        listing_add(s, l, name_at(g, i));
    }
}

static void list_part(source *s, listing *l, const joint *j, const char *part, const char *ending)
{
    listing_add(s, l, (name){arena_format(s->memory, "%s%s%s", j->name.text, part, ending), j->name.at});
}

/* A joint of several parts declares NAME_first and so on. */
static void list_parts(source *s, listing *l, const joint *j)
{
    static const char *const of_ball[] = {"_w", "_x", "_y", "_z"}, *const of_frame[] = {"_x", "_y", "_z"};
    const joint_part *parts = joint_rows[j->kind].parts;
    for (int i = 0; i < joint_parts_count(j->kind) && j->name.text != NULL; i++) {
        if (parts[i].ending != NULL && parts[i].ending[0] != '\0') {
            list_part(s, l, j, parts[i].ending, "");
        }
        for (int n = 0; n < 3 && parts[i].ending == NULL; n++) {
            list_part(s, l, j, of_frame[n], "");
        }
        for (int n = 0; n < 4 && parts[i].kind == JOINT_SPHERICAL; n++) {
            list_part(s, l, j, parts[i].ending, of_ball[n]);
        }
    }
}

/* How often a formula names the time, or a function that can be one of time. */
static int count_times(const formula *f)
{
    static const char *const timed[] = {"time", "sin", "cos", "table", "ramp"};
    int count = 0;
    for (size_t i = 0; i < sizeof timed / sizeof timed[0]; i++) {
        count += f->name != NULL && strcmp(f->name, timed[i]) == 0;
    }
    for (size_t i = 0; i < f->count; i++) {
        count += count_times(f->parts[i]);
    }
    return count;
}

int closure_clocks(const closure_statement *c)
{
    const formula *f = c->motion != NULL ? c->motion : c->speed;
    return f == NULL ? 0 : count_times(f);
}

const effect_kind *find_effect_kind(const scene *written, name n)
{
    const int found = INDEX_OF(written->effect_kinds, n.text);
    return found < 0 ? NULL : &written->effect_kinds.all[found];
}

const char *const effect_endings[] = {"_x", "_y", "_z", ""};

/* The names of an effect stand in plant.h as EFFECT_NAME. */
static void list_effect(source *s, const scene *written, const effect_use *use, listing *held, listing *parameters)
{
    const effect_kind *kind = find_effect_kind(written, use->kind);
    for (size_t i = 0; kind != NULL && use->name.text != NULL && i < kind->line_count; i++) {
        const effect_line *line = &kind->lines[i];
        listing *l = line->kind == EFFECT_MEMORY ? held : line->kind == EFFECT_FAULT ? parameters : NULL;
        for (int part = 0; part < line->parts && l != NULL && line->name.text != NULL; part++) {
            const char *called = arena_format(s->memory, "%s_%s%s", use->name.text, line->name.text,
                                              effect_endings[line->parts == 3 ? part : 3]);
            listing_add(s, l, (name){called, use->name.at});
        }
    }
}

const char *output_components(const scene *written, const output *o)
{
    const formula *f = o->formula;
    if (f->kind != FORMULA_OF || f->along.text != NULL) {
        return "";
    }
    const char *owner = f->parts[0]->name;
    const bool is_body = INDEX_OF(written->bodies, owner) >= 0 || INDEX_OF(written->frames, owner) >= 0;
    const quantity_kind kind = quantity_called(f->name, is_body ? OF_BODY : OF_CONNECTION);
    return kind < QUANTITY_ROWS ? quantity_rows[kind].components : "";
}

/* output NAME = power, where an input has the name `power`: the word means the power of the mechanism, and the user may
 * mean the input. */
static void refuse_doubtful(source *s, const scene *written, const output *o)
{
    const group numbers[] = {GROUP(written->parameters), GROUP(written->inputs), GROUP(written->signals)};
    const formula *f = o->formula;
    const bool is_alone = f->kind == FORMULA_NAME && quantity_of_nothing(f->name) < QUANTITY_ROWS;
    for (size_t i = 0; i < 3 && is_alone; i++) {
        if (find_among(numbers[i], (name){f->name, f->at}) >= 0) {
            source_problem(s, f->at,
                           "'%s' is of the mechanism, but something else is called so too: for that one "
                           "write 1 * %s, or choose another name for it",
                           f->name, f->name);
        }
    }
}

/* Outputs have a name space of their own: an output may have the name of the quantity that it shows. */
void names_check(source *s, const scene *written)
{
    listing things = {0}, kinds = {0}, held = {0}, parameters = {0};
    const group all[] = {GROUP(written->bodies),     GROUP(written->frames),  GROUP(written->joints),
                         GROUP(written->closures),   GROUP(written->springs), GROUP(written->forces),
                         GROUP(written->parameters), GROUP(written->inputs),  GROUP(written->signals),
                         GROUP(written->effects)};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        list_group(s, &things, all[i]);
    }
    list_group(s, &kinds, GROUP(written->effect_kinds));
    list_group(s, &held, GROUP(written->inputs));
    list_group(s, &parameters, GROUP(written->parameters));
    for (size_t i = 0; i < written->outputs.count; i++) {
        refuse_doubtful(s, written, &written->outputs.all[i]);
    }
    for (size_t i = 0; i < written->joints.count; i++) {
        list_parts(s, &things, &written->joints.all[i]);
    }
    for (size_t i = 0; i < written->effects.count; i++) {
        list_effect(s, written, &written->effects.all[i], &held, &parameters);
    }
    listing_check(s, &things);
    listing_check(s, &kinds);
    listing_check(s, &held);
    listing_check(s, &parameters);
}

static size_t collect(const char **names, group g)
{
    size_t found = 0;
    for (size_t i = 0; i < g.count; i++) {
        const name n = name_at(g, i);
        if (n.text != NULL) {
            names[found++] = n.text;
        }
    }
    return found;
}

/* The nearest to a mistyped name among these groups, and `more` further names. */
static const char *suggest_among(source *s, const group *groups, size_t count, const char *typed, const char **more,
                                 size_t more_count)
{
    size_t room = more_count, listed = more_count;
    for (size_t i = 0; i < count; i++) {
        room += groups[i].count;
    }
    const char **names = arena_take(s->memory, room + 1, sizeof *names);
    for (size_t i = 0; i < more_count; i++) {
        names[i] = more[i];
    }
    for (size_t i = 0; i < count; i++) {
        listed += collect(names + listed, groups[i]);
    }
    return source_suggestion(s, typed, names, listed);
}

const char *suggest_kind(source *s, const scene *written, const char *typed)
{
    const group kinds = GROUP(written->effect_kinds);
    size_t count = 0, room = 0;
    const char **library = NULL;
    for (const embedded_file *f = effect_files; f->path != NULL; f++) {
        const char *base = strrchr(f->path, '/') + 1;
        ADD_TO(s->memory, library, count, room, (arena_copy(s->memory, base, strcspn(base, "."))));
    }
    return suggest_among(s, &kinds, 1, typed, library, count);
}

const char *suggest_effect(source *s, const scene *written, const char *typed)
{
    const group effects = GROUP(written->effects);
    return suggest_among(s, &effects, 1, typed, NULL, 0);
}

const char *suggest_setting(source *s, const scene *written, const char *typed)
{
    const group parameters = GROUP(written->parameters);
    size_t count = 0, room = 0;
    const char **faults = NULL;
    FOR_EACH (const effect_use, use, written->effects) {
        const effect_kind *kind = use->name.text == NULL ? NULL : find_effect_kind(written, use->kind);
        for (size_t n = 0; kind != NULL && n < kind->line_count; n++) {
            const effect_line *line = &kind->lines[n];
            if (line->kind == EFFECT_FAULT && line->name.text != NULL) {
                ADD_TO(s->memory, faults, count, room,
                       arena_format(s->memory, "%s.%s", use->name.text, line->name.text));
            }
        }
    }
    return suggest_among(s, &parameters, 1, typed, faults, count);
}

const char *suggest_number(source *s, const scene *written, const char *typed, bool in_formula)
{
    const group groups[] = {GROUP(written->parameters), GROUP(written->inputs), GROUP(written->signals)};
    const char *words[QUANTITY_ROWS];
    size_t count = 0;
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS && in_formula; kind++) {
        if (quantity_rows[kind].owner < OF_COORDINATE) {
            words[count++] = quantity_rows[kind].word;
        }
    }
    return suggest_among(s, groups, in_formula ? 3 : 1, typed, words, count);
}

/* The index in these groups, one after the other; `more` is a further name to suggest. */
static int find_in(source *s, const group *groups, size_t count, const char *more, name n, const char *what)
{
    size_t before = 0;
    for (size_t i = 0; i < count; i++) {
        const int found = find_among(groups[i], n);
        if (found >= 0) {
            return (int)before + found;
        }
        before += groups[i].count;
    }
    source_problem(s, n.at, "no %s is called '%s'%s", what, n.text,
                   suggest_among(s, groups, count, n.text, &more, more != NULL));
    return -1;
}

int find_body(source *s, const scene *written, name n)
{
    const group groups[] = {GROUP(written->bodies), GROUP(written->frames)};
    return strcmp(n.text, "ground") == 0 ? -2 : find_in(s, groups, 2, "ground", n, "body");
}

int find_joint(source *s, const scene *written, name n)
{
    const group joints = GROUP(written->joints);
    return find_in(s, &joints, 1, NULL, n, "joint");
}

int find_input(source *s, const scene *written, name n)
{
    const group inputs = GROUP(written->inputs);
    return find_in(s, &inputs, 1, NULL, n, "input");
}

int find_closure_or_spring(source *s, const scene *written, name n, bool *is_closure)
{
    const group groups[] = {GROUP(written->closures), GROUP(written->springs)};
    const int found = find_in(s, groups, 2, NULL, n, "closure or spring"), closures = (int)written->closures.count;
    *is_closure = found >= 0 && found < closures;
    return found < closures ? found : found - closures;
}

/* The index among the joints, or behind them. */
static int find_joint_or(source *s, const scene *written, const group *others, size_t count, name n, const char *what,
                         bool *is_joint)
{
    group groups[3] = {GROUP(written->joints)};
    memcpy(groups + 1, others, count * sizeof *others);
    const int found = find_in(s, groups, 1 + count, NULL, n, what), joints = (int)written->joints.count;
    *is_joint = found >= 0 && found < joints;
    return found < joints ? found : found - joints;
}

int find_joint_or_body(source *s, const scene *written, name n, bool *is_joint)
{
    const group others[] = {GROUP(written->bodies), GROUP(written->frames)};
    return find_joint_or(s, written, others, 2, n, "joint or body", is_joint);
}

int find_joint_or_closure(source *s, const scene *written, name n, bool *is_joint)
{
    const group closures = GROUP(written->closures);
    return find_joint_or(s, written, &closures, 1, n, "joint or closure", is_joint);
}
