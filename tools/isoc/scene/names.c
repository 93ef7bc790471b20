#include "tools/isoc/scene/names.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "tools/isoc/base/embedded.h"

void listing_add(source *s, name_list *l, name n)
{
    if (n.text != NULL) {
        LIST_ADD(s->memory, *l, n);
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

void listing_check(source *s, name_list *l)
{
    if (l->count > 1) {
        qsort(l->all, l->count, sizeof *l->all, by_text);
    }
    for (size_t i = 1; i < l->count; i++) {
        const name *first = &l->all[i - 1], *again = &l->all[i];
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

static int find_among(group g, const char *called)
{
    for (size_t i = 0; i < g.count; i++) {
        if (name_is(name_at(g, i), called)) {
            return (int)i;
        }
    }
    return -1;
}

int index_called(const void *things, size_t count, size_t size, const char *called)
{
    return find_among((group){things, count, size}, called);
}

#define GROUP(list) ((group){(list).all, (list).count, sizeof *(list).all})

static void list_group(source *s, name_list *l, group g)
{
    for (size_t i = 0; i < g.count; i++) {
        listing_add(s, l, name_at(g, i));
    }
}

static void list_part(source *s, name_list *l, const joint *j, const char *part, const char *ending)
{
    listing_add(s, l, (name){arena_format(s->memory, "%s%s%s", j->name.text, part, ending), j->name.at});
}

/* A joint of several parts declares NAME_first and so on. */
static void list_parts(source *s, name_list *l, const joint *j)
{
    static const char *const of_ball[] = {"_w", "_x", "_y", "_z"};
    const joint_part *parts = joint_rows[j->kind].parts;
    for (int i = 0; i < joint_parts_count(j->kind) && j->name.text != NULL; i++) {
        if (parts[i].ending != NULL && parts[i].ending[0] != '\0') {
            list_part(s, l, j, parts[i].ending, "");
        }
        for (int n = 0; n < 3 && parts[i].ending == NULL; n++) {
            list_part(s, l, j, of_ball[1 + n], "");
        }
        for (int n = 0; n < 4 && parts[i].kind == JOINT_SPHERICAL; n++) {
            list_part(s, l, j, parts[i].ending, of_ball[n]);
        }
    }
}

/* The number of times that a formula names the time, or a function that can be one of time. */
static int count_times(const formula *f)
{
    static const char *const timed[] = {"time", "sin", "cos", "table", "ramp"};
    int count = 0;
    for (size_t i = 0; i < COUNT_OF(timed); i++) {
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

const quantity *operand_called(const effect_use *use, const char *called)
{
    const int i = index_called(use->operands, use->operand_count, sizeof *use->operands, called);
    return i < 0 ? NULL : &use->operands[i];
}

const char *const effect_endings[] = {"_x", "_y", "_z", ""};

const char *held_name(arena *memory, const effect_use *use, name kept)
{
    return use == NULL ? arena_format(memory, "%s_held", kept.text)
                       : arena_format(memory, "%s_%s_held", use->symbol, kept.text);
}

/* The names of an effect stand in plant.h as EFFECT_NAME. */
static void list_effect(source *s, const scene *written, const effect_use *use, name_list *held, name_list *parameters)
{
    const effect_kind *kind = find_effect_kind(written, use->kind);
    for (size_t i = 0; kind != NULL && use->name.text != NULL && i < kind->line_count; i++) {
        const effect_line *line = &kind->lines[i];
        name_list *l = line->kind == EFFECT_MEMORY ? held : line->kind == EFFECT_FAULT ? parameters : NULL;
        for (int part = 0; part < line->parts && l != NULL && line->name.text != NULL; part++) {
            const char *called = arena_format(s->memory, "%s_%s%s", use->symbol, line->name.text,
                                              effect_endings[line->parts == 3 ? part : 3]);
            listing_add(s, l, (name){called, use->name.at});
        }
        const bool is_held = line->kind == EFFECT_LET || (line->kind == EFFECT_OUTPUT && line->value != NULL);
        if (is_held && (line->block != NULL || use->block != NULL || use->outer >= 0) && line->name.text != NULL) {
            listing_add(s, held, (name){held_name(s->memory, use, line->name), line->name.at});
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
        if (find_among(numbers[i], f->name) >= 0) {
            source_problem(s, f->at,
                           "'%s' is a quantity of the mechanism, and something else has that name: for the latter "
                           "write 1 * %s, or choose another name for it",
                           f->name, f->name);
        }
    }
}

/* Outputs have a name space of their own: an output may have the name of the quantity that it shows. */
void names_check(source *s, const scene *written)
{
    name_list things = {0}, kinds = {0}, held = {0}, parameters = {0};
    const group all[] = {GROUP(written->bodies),     GROUP(written->frames),      GROUP(written->joints),
                         GROUP(written->closures),   GROUP(written->springs),     GROUP(written->forces),
                         GROUP(written->parameters), GROUP(written->inputs),      GROUP(written->signals),
                         GROUP(written->effects),    GROUP(written->events.modes)};
    for (size_t i = 0; i < COUNT_OF(all); i++) {
        list_group(s, &things, all[i]);
    }
    list_group(s, &kinds, GROUP(written->effect_kinds));
    list_group(s, &held, GROUP(written->inputs));
    list_group(s, &parameters, GROUP(written->parameters));
    for (size_t i = 0; i < written->outputs.count; i++) {
        refuse_doubtful(s, written, &written->outputs.all[i]);
    }
    FOR_EACH (const quantity, q, written->signals) {
        if (q->block != NULL && q->name.text != NULL) {
            listing_add(s, &held, (name){held_name(s->memory, NULL, q->name), q->name.at});
        }
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

typedef LIST_OF(const char *) word_list;

static void add_names(source *s, word_list *to, group g)
{
    for (size_t i = 0; i < g.count; i++) {
        const name n = name_at(g, i);
        if (n.text != NULL) {
            LIST_ADD(s->memory, *to, n.text);
        }
    }
}

const char *suggest_kind(source *s, const scene *written, const char *typed)
{
    word_list known = {0};
    for (const embedded_file *f = effect_files; f->path != NULL; f++) {
        const char *base = strrchr(f->path, '/') + 1;
        LIST_ADD(s->memory, known, arena_copy(s->memory, base, strcspn(base, ".")));
    }
    add_names(s, &known, GROUP(written->effect_kinds));
    return source_suggestion(s, typed, known.all, known.count);
}

const char *suggest_effect(source *s, const scene *written, const char *typed)
{
    word_list known = {0};
    add_names(s, &known, GROUP(written->effects));
    return source_suggestion(s, typed, known.all, known.count);
}

const char *suggest_setting(source *s, const scene *written, const char *typed)
{
    word_list known = {0};
    FOR_EACH (const effect_use, use, written->effects) {
        const effect_kind *kind = use->name.text == NULL ? NULL : find_effect_kind(written, use->kind);
        for (size_t n = 0; kind != NULL && n < kind->line_count; n++) {
            const effect_line *line = &kind->lines[n];
            if (line->kind == EFFECT_FAULT && line->name.text != NULL) {
                LIST_ADD(s->memory, known, arena_format(s->memory, "%s.%s", use->name.text, line->name.text));
            }
        }
    }
    add_names(s, &known, GROUP(written->parameters));
    return source_suggestion(s, typed, known.all, known.count);
}

const char *suggest_number(source *s, const scene *written, const char *typed, bool in_formula)
{
    word_list known = {0};
    for (quantity_kind kind = 0; kind < QUANTITY_ROWS && in_formula; kind++) {
        if (quantity_rows[kind].owner < OF_COORDINATE) {
            LIST_ADD(s->memory, known, quantity_rows[kind].word);
        }
    }
    add_names(s, &known, GROUP(written->parameters));
    if (in_formula) {
        add_names(s, &known, GROUP(written->inputs));
        add_names(s, &known, GROUP(written->signals));
        add_names(s, &known, GROUP(written->events.modes));
    }
    return source_suggestion(s, typed, known.all, known.count);
}

/* The index in these groups, one after the other; `more` is a further name to suggest. */
static int find_in(source *s, const group *groups, size_t count, const char *more, name n, const char *what)
{
    size_t before = 0;
    for (size_t i = 0; i < count; i++) {
        const int found = find_among(groups[i], n.text);
        if (found >= 0) {
            return (int)before + found;
        }
        before += groups[i].count;
    }
    word_list known = {0};
    if (more != NULL) {
        LIST_ADD(s->memory, known, more);
    }
    for (size_t i = 0; i < count; i++) {
        add_names(s, &known, groups[i]);
    }
    source_problem(s, n.at, "no %s is called '%s'%s", what, n.text,
                   source_suggestion(s, n.text, known.all, known.count));
    return -1;
}

int find_body(source *s, const scene *written, name n)
{
    const group groups[] = {GROUP(written->bodies), GROUP(written->frames)};
    return strcmp(n.text, "ground") == 0 ? -2 : find_in(s, groups, 2, "ground", n, "body");
}

int find_joint(source *s, const scene *written, name n)
{
    return find_in(s, &GROUP(written->joints), 1, NULL, n, "joint");
}

int find_input(source *s, const scene *written, name n)
{
    return find_in(s, &GROUP(written->inputs), 1, NULL, n, "input");
}

int find_effect(source *s, const scene *written, name n)
{
    return find_in(s, &GROUP(written->effects), 1, NULL, n, "effect");
}

/* The index in the first group, or in those behind it. */
static int find_first_or(source *s, const group *groups, size_t count, name n, const char *what, bool *is_first)
{
    const int found = find_in(s, groups, count, NULL, n, what), first = (int)groups[0].count;
    *is_first = found >= 0 && found < first;
    return found < first ? found : found - first;
}

int find_closure_or_spring(source *s, const scene *written, name n, bool *is_closure)
{
    const group groups[] = {GROUP(written->closures), GROUP(written->springs)};
    return find_first_or(s, groups, 2, n, "closure or spring", is_closure);
}

int find_joint_or_body(source *s, const scene *written, name n, bool *is_joint)
{
    const group groups[] = {GROUP(written->joints), GROUP(written->bodies), GROUP(written->frames)};
    return find_first_or(s, groups, 3, n, "joint or body", is_joint);
}

int find_joint_or_closure(source *s, const scene *written, name n, bool *is_joint)
{
    const group groups[] = {GROUP(written->joints), GROUP(written->closures)};
    return find_first_or(s, groups, 2, n, "joint or closure", is_joint);
}
