/* Effects: each use of one is its definition with the operands put in. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

#include "tools/isoc/scene/names.h"

/* The use's text for an operand, which is the name of a joint or of a body; NULL if it gives none. */
static const quantity *name_given(effect_scope *w, const instance *in, const effect_line *line, const char *what)
{
    const quantity *argument = operand_called(in->use, line->name.text);
    if (argument == NULL || argument->value == NULL) {
        return NULL;
    }
    if (argument->value->kind != FORMULA_NAME) {
        source_problem(w->b->s, argument->value->at, "expected the name of a %s for '%s'", what, line->name.text);
        return NULL;
    }
    return argument;
}

/* The joint that the use names for an operand. */
static int bound_segment(effect_scope *w, const instance *in, const effect_line *line)
{
    const quantity *argument = name_given(w, in, line, "joint");
    if (argument == NULL) {
        return -1;
    }
    const int found = segment_of(w, (name){argument->value->name, argument->value->at});
    if (found >= 0 && line->is_bounded && w->b->mechanism.segments[found].continuous) {
        source_problem(w->b->s, argument->value->at,
                       "'%s' is continuous: its angle begins again at every turn, which the effect %s cannot follow",
                       argument->value->name, in->kind->name.text);
    }
    return found;
}

/* The body that an operand of the effect around is, and a point beside that of the operand. */
static int bound_body_of_outer(effect_scope *w, const quantity *argument, vector *point)
{
    const vector beside = *point;
    int which;
    if (!find_point(w, argument->value->name, &which, point)) {
        source_problem(w->b->s, argument->value->at, "this effect has no body '%s'", argument->value->name);
    }
    *point = vector_add(w->b->g, *point, beside);
    return which;
}

/* The body that it names, and its point. */
static int bound_body(effect_scope *w, const instance *in, const effect_line *line, vector *point)
{
    const quantity *argument = name_given(w, in, line, "body");
    *point = vector_zero(w->b->g);
    if (argument == NULL) {
        return -1;
    }
    w->b->values.around = in->outer == NULL ? NULL : w->b->around;
    *point = vector_value(w->b, argument->point, metre, "a point");
    w->b->values.around = NULL;
    if (in->outer != NULL) {
        return bound_body_of_outer(w, argument, point);
    }
    const int found = find_body(w->b->s, w->b->written, (name){argument->value->name, argument->value->at});
    if (found == -2) {
        source_problem(w->b->s, argument->value->at, "the ground does not move: '%s' is a body", line->name.text);
    }
    return found < 0 ? -1 : found;
}

/* Checks the operands: each once, none but those of the definition, and none missing that has no default. */
static bool check_operands(builder *b, const instance *in)
{
    source *s = b->s;
    const size_t problems = s->problem_count;
    FOR_ALL (const quantity, argument, in->use->operands, in->use->operand_count) {
        const effect_line *line = line_called(in->kind, argument->name.text, false);
        if (line == NULL || line->kind >= EFFECT_FAULT) {
            source_problem(s, argument->name.at, "the effect %s has no operand '%s'%s", in->kind->name.text,
                           argument->name.text,
                           suggestion(s, in->kind, argument->name.text, EFFECT_JOINT, EFFECT_VALUE));
        } else if (operand_called(in->use, argument->name.text) != argument) {
            source_problem(s, argument->name.at, "a second '%s'", argument->name.text);
        }
    }
    FOR_ALL (const effect_line, line, in->kind->lines, in->kind->line_count) {
        if (line->kind < EFFECT_FAULT && line->value == NULL && line->name.text != NULL &&
            operand_called(in->use, line->name.text) == NULL) {
            source_problem(s, in->use->name.at, "'%s' has no %s: the effect %s needs it", in->use->name.text,
                           line->name.text, in->kind->name.text);
        }
    }
    return s->problem_count == problems;
}

/* In a block of a rate are effects whose numbers a row can keep; those that act within a step stand outside. */
static bool check_rate(effect_scope *w, const instance *in)
{
    FOR_ALL (const effect_line, line, in->kind->lines, is_slow(rate_of_use(w, in)) ? in->kind->line_count : 0) {
        if (line->kind == EFFECT_STATE || (line->kind >= EFFECT_EFFORT && line->kind <= EFFECT_WORK) ||
            line->kind == EFFECT_WHEN || line->kind == EFFECT_HOLD) {
            return source_problem(w->b->s, in->use->kind.at,
                                  "the effect %s acts within a step, in %s: it stands outside of a block of a rate",
                                  in->kind->name.text, source_line(w->b->s, line->at));
        }
    }
    return true;
}

/* The value of a fault at the start: 0, or that of --set. */
static double start_of_fault(builder *b, const char *display_name)
{
    double start = 0.0;
    FOR_EACH (const setting, set, b->written->fault_starts) {
        if (set->value != NULL && strcmp(set->what.text, display_name) == 0) {
            start = value_constant(&b->values, set->value, no_unit, display_name, 0.0);
            if (!(start >= 0.0 && start <= 1.0)) {
                source_problem(b->s, set->value->at, "'%s' is from 0 to 1", display_name);
            }
        }
    }
    return start;
}

/* A switch: a tunable of its own, which is 0 until somebody sets it to 1. */
static int add_fault(builder *b, const effect_use *use, const effect_line *line)
{
    const char *called = arena_format(b->s->memory, "%s_%s", use->symbol, line->name.text);
    const char *display_name = arena_format(b->s->memory, "%s.%s", use->name.text, line->name.text);
    const double start = start_of_fault(b, display_name);
    const variable fault = {.name = called,
                            .unit = "1",
                            .display_name = display_name,
                            .quote = source_quote(b->s, line->name.at),
                            .start = start,
                            .most = 1.0};
    LIST_ADD(b->s->memory, b->faults, fault);
    ADD_TO(b->s->memory, b->values.defaults, b->values.tunables, b->values.default_room, start);
    return b->values.tunables - 1;
}

static void build_instance(effect_scope *w, instance *in, int *states, int *memories)
{
    builder *b = w->b;
    if (in->outer != NULL && in->outer->kind == NULL) { /* what has it is wrong, which was told */
        return;
    }
    enter(w, in->outer);
    in->kind = find_effect_kind(b->written, in->use->kind);
    if (in->kind == NULL && in->use->kind.text != NULL) {
        source_problem(b->s, in->use->kind.at, "no effect of the kind '%s' is defined%s", in->use->kind.text,
                       suggest_kind(b->s, b->written, in->use->kind.text));
    }
    if (in->kind == NULL || in->kind->broken || in->use->broken || !check_operands(b, in) || !check_rate(w, in)) {
        in->kind = NULL;
        b->is_effect_broken = true;
        return;
    }
    in->bound = arena_take(b->s->memory, in->kind->line_count + 1, sizeof *in->bound);
    for (size_t i = 0; i < in->kind->line_count; i++) {
        const effect_line *line = &in->kind->lines[i];
        in->bound[i].segment = line->kind == EFFECT_JOINT ? bound_segment(w, in, line) : -1;
        in->bound[i].body = line->kind == EFFECT_BODY ? bound_body(w, in, line, &in->bound[i].point) : -1;
        in->bound[i].index = -1;
        if (in->use->left_out) {
            continue;
        }
        if (line->kind == EFFECT_FAULT) {
            in->bound[i].index = add_fault(b, in->use, line);
        } else if (line->kind == EFFECT_STATE || line->kind == EFFECT_MEMORY) {
            int *next = line->kind == EFFECT_STATE ? states : memories;
            in->bound[i].index = *next;
            *next += line->parts;
        }
    }
}

static effect_scope *effect_scope_of(builder *b)
{
    arena *memory = b->s->memory;
    effect_scope *w = arena_take(memory, 1, sizeof *w);
    w->b = b;
    w->all = arena_take(memory, b->written->effects.count + 1, sizeof *w->all);
    w->rate = each_row;
    w->held_signals = arena_take(memory, b->written->signals.count + 1, sizeof *w->held_signals);
    w->signals = arena_take(memory, b->written->signals.count + 1, sizeof *w->signals);
    w->signal_progress = arena_take(memory, b->written->signals.count + 1, sizeof *w->signal_progress);
    w->is_mode_known = arena_take(memory, b->written->events.modes.count + 1, sizeof *w->is_mode_known);
    for (size_t i = 0; i < b->written->effects.count; i++) {
        w->all[i].use = &b->written->effects.all[i];
        w->all[i].account = &b->mechanism.effects.accounts[i];
        w->all[i].outer = w->all[i].use->outer < 0 ? NULL : &w->all[w->all[i].use->outer];
        w->all[i].shown = (name){w->all[i].use->name.text, w->all[i].use->used_at};
    }
    return w;
}

void build_effects(builder *b)
{
    effect_scope *w = effect_scope_of(b);
    surroundings *around = arena_take(b->s->memory, 1, sizeof *around);
    *around = (surroundings){.context = w,
                             .find = find_name,
                             .call = call_value,
                             .quantity = quantity_value,
                             .history_memory = history_memory_value,
                             .time_input = time_input_value};
    b->around = around;
    int states = 0, memories = 0;
    for (size_t i = 0; i < b->written->effects.count; i++) {
        build_instance(w, &w->all[i], &states, &memories);
        enter(w, NULL);
    }
    w->first_mode = states;
    b->values.around = around;
    graph_section(b->g, "Effects");
    FOR_ALL (const instance, in, w->all, b->written->effects.count) {
        if (in->kind != NULL && !in->use->left_out) {
            FOR_ALL (const effect_line, line, in->kind->lines, in->kind->line_count) {
                do_line(w, in, line);
            }
            check_subjects(w, in);
        }
    }
    for (size_t i = 0; i < b->written->signals.count; i++) {
        if (!b->written->signals.all[i].left_out) {
            (void)signal_value(w, i);
        }
    }
    for (size_t i = 0; i < b->written->events.modes.count; i++) {
        (void)mode_value(w, i);
    }
    w->is_done = true;
    b->values.around = NULL;
}

value value_in_scene(builder *b, const formula *f)
{
    b->values.around = b->around;
    const value found = value_any(&b->values, f);
    b->values.around = NULL;
    return found;
}
