#include "tools/isoc/linear/linear.h"

#include "tools/isoc/scene/parser.h"
#include "tools/isoc/scene/take.h"

/* Whether both are the same name: `drive.current` is drive_current in a header. */
static bool is_called(const char *called, const char *typed)
{
    size_t i = 0;
    while (called[i] != '\0' && (called[i] == typed[i] || (called[i] == '_' && typed[i] == '.'))) {
        i++;
    }
    return called[i] == '\0' && typed[i] == '\0';
}

static const char *const sorts[] = {"input", "output", "state"}; /* trim_sort */

labels labels_of(const plant *p, arena *memory, trim_sort sort)
{
    const mechanism *m = p->m;
    if (sort == TRIM_OUTPUT) {
        return (labels){p->outputs.names, p->outputs.units, p->outputs.count};
    }
    labels result = {.count = sort == TRIM_INPUT ? m->inputs.count : state_count(m)};
    result.names = arena_take(memory, (size_t)result.count + 1, sizeof *result.names);
    result.units = arena_take(memory, (size_t)result.count + 1, sizeof *result.units);
    const state *states = mechanism_states(m, memory);
    for (int i = 0; i < result.count; i++) {
        const variable *about = sort == TRIM_INPUT ? &m->inputs.all[i] : &states[i].about;
        result.names[i] = about->name;
        result.units[i] = about->unit;
    }
    return result;
}

/* Finds a name: of an input, else an output, else a state; or of one sort alone, whose word stands before it. */
static bool find_quantity(parser *p, const plant *subject, trim_condition *w, int sort)
{
    const char *all[256];
    size_t known = 0;
    for (int which = sort < 0 ? TRIM_INPUT : sort; which <= (sort < 0 ? (int)TRIM_STATE : sort); which++) {
        const labels names = labels_of(subject, p->s->memory, (trim_sort)which);
        for (int i = 0; i < names.count; i++) {
            if (is_called(names.names[i], w->name)) {
                w->sort = (trim_sort)which;
                w->index = i;
                w->name = names.names[i];
                w->unit = names.units[i];
                return true;
            }
            if (known < COUNT_OF(all)) {
                all[known++] = names.names[i];
            }
        }
    }
    return PARSE_FAULT(p, w->at, "no %s is called '%s'%s", sort < 0 ? "input, output or state" : sorts[sort], w->name,
                       source_suggestion(p->s, w->name, all, known));
}

/* A condition with its formula; NULL where it is free. */
static formula *read_condition(parser *p, const plant *subject, trim_condition *w)
{
    int sort = -1;
    w->is_free = next_is_word(p, "free") && p->next[1].kind == TOKEN_NAME && take_word(p, "free");
    for (int i = 0; i < 3 && sort < 0; i++) {
        sort = next_is_word(p, sorts[i]) && p->next[1].kind == TOKEN_NAME && take_word(p, sorts[i]) ? i : -1;
    }
    if (p->next->kind != TOKEN_NAME) {
        parse_problem(p, "expected rest, NAME = VALUE, or free NAME");
        return NULL;
    }
    *w = (trim_condition){.at = p->next->at, .name = p->next->text, .is_free = w->is_free};
    p->next++;
    if (!find_quantity(p, subject, w, sort)) {
        return NULL;
    }
    if (w->is_free && w->sort != TRIM_INPUT) {
        PARSE_FAULT(p, w->at, "'%s' is no input: only an input can be free", w->name);
    }
    if (!w->is_free) {
        expect_sign(p, '=', "expected = and a value");
    }
    return p->failed || w->is_free ? NULL : parse_formula(p);
}

/* Its value as a number, of the dimension of its input, output or state. */
static void evaluate_condition(values *v, trim_condition *w, const formula *f)
{
    const value found = value_any(v, f);
    const dimension expected = unit_of_text(v->s->memory, w->unit).dim;
    if (found.count == 0) {
        return;
    }
    if (found.count != 1) {
        source_problem(v->s, f->at, "'%s' is a number; this is none", w->name);
    } else if (!found.any && !dimension_equal_but_angle(found.dim, expected)) {
        source_problem(v->s, f->at, "'%s' is in %s; this %s", w->name, w->unit,
                       dimension_phrase(v->s->memory, found.dim));
    } else {
        w->value = value_now(v, found.parts[0]);
    }
}

/* The data of the reader of conditions. */
typedef struct reading {
    const plant *subject;
    values v;
    trim_conditions result;
} reading;

static void add_condition(parser *p, void *to)
{
    reading *r = to;
    trim_condition w = {0};
    const formula *f = read_condition(p, r->subject, &w);
    if (!p->failed && f != NULL) {
        evaluate_condition(&r->v, &w, f);
    }
    if (!p->failed) {
        LIST_ADD(p->s->memory, r->result, w);
    }
}

trim_conditions trim_conditions_read(source *s, graph *g, const scene *written, const plant *p, const script *list)
{
    static const char further[] = "expected ; and a further condition";
    scene with = *written;
    parser at = parser_of_option(s, &with, list, list);
    reading r = {.subject = p};
    values_start(&r.v, s, g, written, (size_t)p->m->parameters.count, true);
    values_resolve(&r.v);
    if (take_word(&at, "rest") && at.next->kind != TOKEN_END) {
        expect_sign(&at, ';', further);
    }
    parse_items(&at, add_condition, &r, further);
    return r.result;
}
