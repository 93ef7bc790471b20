/* The values of the lines of an effect. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

#include "tools/isoc/scene/names.h"

/* The dimension of the position, speed or effort of a coordinate; of effort per position, or per speed. */
static dimension like_dimension(const char *word, const segment *l)
{
    const bool is_stiffness = strcmp(word, "stiffness") == 0, is_damping = strcmp(word, "damping") == 0;
    const char *first = is_stiffness || is_damping ? "effort" : word;
    const quantity_kind kind = quantity_called(first, OF_COORDINATE);
    dimension result = quantity_dimension(kind < QUANTITY_ROWS ? kind : quantity_called(first, OF_TRANSMISSION), l);
    if (is_stiffness || is_damping) {
        const quantity_kind below = quantity_called(is_stiffness ? "position" : "speed", OF_COORDINATE);
        dimension_times(&result, quantity_dimension(below, l), -1);
    }
    return result;
}

/* The dimension that a line declares, by its unit, by `like`, or by its default; or false. */
static bool declared_dimension(effect_scope *w, const instance *in, const effect_line *line, const formula *f,
                               dimension *expected)
{
    const bool has_default = line->kind <= EFFECT_VALUE && line->value != NULL && line->value != f;
    if (line->has_unit) {
        *expected = line->unit.dim;
    } else if (has_default && line->like.text == NULL) {
        const value found = evaluate(w, in, line->value, line->name.text);
        *expected = found.dim;
        return found.count > 0;
    } else if (line->like.text != NULL && line->like_of.text != NULL) {
        const instance *before = enter(w, in);
        const int l = segment_of(w, line->like_of);
        enter(w, before);
        *expected = l < 0 ? no_unit : like_dimension(line->like.text, &w->b->mechanism.segments[l]);
    }
    return line->has_unit || line->like.text != NULL;
}

/* One number, or a vector where it starts as one or has one as its default, of the dimension that the line declares, if
 * it does. */
static value checked(effect_scope *w, const instance *in, const effect_line *line, const formula *f, value found)
{
    dimension expected;
    source *s = w->b->s;
    if (found.count > 0 && found.count != line->parts) {
        const char *is = line->parts == 1 ? "one number" : "a vector (x, y, z)";
        return REFUSED(s, f->at, "'%s' is %s; this is %s", line->name.text, is,
                       found.count == 1 ? "one number" : arena_format(s->memory, "%d", found.count));
    }
    if (found.count == 0 || !declared_dimension(w, in, line, f, &expected)) {
        return found;
    }
    if (!found.any && !dimension_equal_but_angle(found.dim, expected)) {
        return REFUSED(s, f->at, "'%s' %s; this %s", line->name.text, dimension_phrase(s->memory, expected),
                       dimension_phrase(s->memory, found.dim));
    }
    found.dim = expected;
    found.any = false;
    return found;
}

/* Whether a formula has a word for a limit of step and method. */
static bool names_limit(const formula *f)
{
    bool is = f->kind == FORMULA_NAME && is_limit(f->name);
    for (size_t i = 0; i < f->count; i++) {
        is = is || names_limit(f->parts[i]);
    }
    return is;
}

/* Prints the value that isoc chose. */
static void note_derived(effect_scope *w, const instance *in, const effect_line *line, value found)
{
    arena *memory = w->b->s->memory;
    effect_quantity next = {.next = found.parts[0], .at = in->use->name.at};
    next.about.name = arena_format(memory, "%s.%s", in->use->name.text, line->name.text);
    next.about.unit = dimension_unit(memory, found.dim);
    LIST_ADD(memory, w->b->mechanism.effects.derived, next);
}

/* Whether a value asks nothing of the mechanism: no position or speed, and no quantity. States of effects are no part
 * of it. */
static bool is_external(const mechanism *m, const graph *g, value v)
{
    bool is = true;
    for (reached r = reach(g, v.parts, (size_t)v.count); reach_next(&r);) {
        const operation op = r.n->op;
        const int of_effect = r.n->index - m->effects.first_state;
        const bool moves = op == OP_STATE && (of_effect < 0 || of_effect >= m->effects.state_count);
        is = is && !moves && op != OP_QUERY && op != OP_DERIVATIVE;
    }
    return is;
}

/* A signal or a value: the formula of the use, with the names of the scene, or the default, with those of the effect.
 */
static value operand_value(effect_scope *w, const instance *in, const effect_line *line)
{
    const quantity *argument = operand_called(in->use, line->name.text);
    const formula *f = argument != NULL ? argument->value : line->value;
    if (f == NULL) {
        return nothing;
    }
    const instance *i = argument != NULL ? in->outer : in, *before = enter(w, i);
    value found = checked(w, in, line, f, evaluate(w, i, f, line->name.text));
    bool changes = false;
    for (int part = 0; part < found.count; part++) {
        changes = changes || can_change(w->b->g, found.parts[part]);
    }
    if (line->is_external && !is_external(&w->b->mechanism, w->b->g, found)) {
        const char *comment = source_comment(w->b->s, line->name.at);
        source_problem(w->b->s, f->at,
                       "'%s' is external: no position, speed or other quantity of the mechanism can change it%s%s",
                       line->name.text, comment[0] == '\0' ? "" : "; it is ", comment);
        found = nothing;
    }
    if (changes && line->kind == EFFECT_VALUE) {
        source_problem(w->b->s, f->at, "'%s' is a constant or a tunable: it cannot change with time", line->name.text);
        found = nothing;
    }
    if (found.count == 1 && argument == NULL && !in->use->left_out &&
        (uses_operation(w->b->g, found.parts, 1, OP_INERTIA) || names_limit(f))) {
        note_derived(w, in, line, found);
    }
    enter(w, before);
    return found;
}

/* The start of a state or a memory, which gives its dimension. */
static value start_value(effect_scope *w, const instance *in, const effect_line *line)
{
    return checked(w, in, line, line->value, evaluate(w, in, line->value, line->name.text));
}

/* A state or a memory that begins so: its numbers from the first on are the leaves of this operation from `index` on.
 */
static value begun(effect_scope *w, const instance *in, const effect_line *line, effect_quantity *first, operation op,
                   int index)
{
    source *s = w->b->s;
    value found = start_value(w, in, line);
    for (int i = 0; i < line->parts; i++) {
        const char *called = arena_format(s->memory, "%s_%s%s", in->use->symbol, line->name.text,
                                          effect_endings[line->parts == 3 ? i : 3]);
        first[i].about = unlimited(called, found.count == 0 ? "1" : dimension_unit(s->memory, found.dim),
                                   source_quote(s, line->name.at));
        first[i].begin = found.count == 0 ? constant(w->b->g, 0.0)
                         : line->is_mode  ? whole_node(w, line->value->at, line->name.text, &found)
                                          : found.parts[i];
        first[i].next = constant(w->b->g, 0.0);
        first[i].effect = (int)(in - w->all);
        first[i].is_mode = line->is_mode;
        first[i].rate = rate_of_line(w, in, line);
        first[i].at = in->use->name.at;
        found.parts[i] = leaf(w->b->g, op, index + i);
    }
    return found;
}

/* A state, a memory or a fault of an effect that is left out: zero, of its dimension. Its start, where that alone gives
 * the dimension, may name later lines, and so change the order of the graph; but no operation of it stays. */
static value absent_value(effect_scope *w, const instance *in, const effect_line *line)
{
    const bool is_known = line->kind == EFFECT_FAULT || line->has_unit;
    value found = is_known ? (value){.count = line->parts, .dim = line->unit.dim} : start_value(w, in, line);
    for (int i = 0; i < line->parts; i++) {
        found.parts[i] = constant(w->b->g, 0.0);
    }
    return found;
}

/* A let that is a constant follows from constants. */
static value checked_constant(effect_scope *w, const effect_line *line, value found)
{
    for (int i = 0; i < found.count && line->is_constant; i++) {
        if (!is_constant(w->b->g, found.parts[i])) {
            return REFUSED(w->b->s, line->value->at, "the constant '%s' depends on what can change: 'let %s = ...'",
                           line->name.text, line->name.text);
        }
    }
    return found;
}

static value new_value(effect_scope *w, const instance *in, const effect_line *line)
{
    graph *g = w->b->g;
    mechanism *m = &w->b->mechanism;
    const size_t i = (size_t)(line - in->kind->lines);
    if (in->use->left_out &&
        (line->kind == EFFECT_FAULT || line->kind == EFFECT_STATE || line->kind == EFFECT_MEMORY)) {
        return absent_value(w, in, line);
    }
    const int at = in->bound[i].index;
    switch (line->kind) {
    case EFFECT_SIGNAL:
    case EFFECT_VALUE:
        return operand_value(w, in, line);
    case EFFECT_FAULT:
        return (value){.count = 1, .parts = {leaf(g, OP_PARAMETER, at)}};
    case EFFECT_STATE:
        return begun(w, in, line, &m->effects.states[at], OP_STATE, m->effects.first_state + at);
    case EFFECT_MEMORY:
        return begun(w, in, line, &m->effects.memories[at], OP_INPUT, m->inputs.count + at);
    default:
        return line->value == NULL ? nothing : checked_constant(w, line, evaluate(w, in, line->value, line->name.text));
    }
}

/* The quantity of an output without a formula: a line that has a name, or else the energy, the loss or the work. */
static const effect_line *line_shown(const effect_kind *kind, const char *called)
{
    const effect_line *found = line_called(kind, called, false);
    FOR_ALL (const effect_line, line, kind->lines, found == NULL ? kind->line_count : 0) {
        if (line->kind >= EFFECT_ENERGY && line->kind <= EFFECT_WORK && strcmp(line->name.text, called) == 0) {
            return line;
        }
    }
    return found;
}

value line_value(effect_scope *w, const instance *in, const effect_line *line)
{
    const effect_line *meant = line;
    if (line->kind == EFFECT_OUTPUT && line->value == NULL) {
        meant = line_shown(in->kind, line->name.text);
        if (meant == NULL || meant->kind <= EFFECT_BODY) {
            return REFUSED(w->b->s, line->name.at, "this effect has no '%s' to show", line->name.text);
        }
    }
    const size_t i = (size_t)(meant - in->kind->lines);
    if (in->bound[i].progress == STARTED) {
        return refuse_loop(w, meant->name.at, meant->name.text);
    }
    const row_rate own = rate_of_line(w, in, meant);
    if (in->bound[i].progress == NOT_YET) {
        in->bound[i].progress = STARTED;
        const row_rate before = pace(w, own);
        in->bound[i].value = new_value(w, in, meant);
        pace(w, before);
        in->bound[i].progress = DONE;
    }
    const bool is_computed = meant->kind == EFFECT_LET || meant->kind == EFFECT_OUTPUT;
    if (!is_computed || !is_slow(own) || is_same_rate(own, w->rate)) {
        return in->bound[i].value;
    }
    return held_value(w, in, &in->bound[i].value, own, held_name(w->b->s->memory, in->use, meant->name), meant->name,
                      &in->bound[i].held);
}
