/* The names in formulas of effects, signals and outputs. */
#include "tools/isoc/effects/effects.h"

#include <string.h>

#include "tools/isoc/scene/names.h"

/* The line of a definition that reads a parameter, an input or a signal of the scene: value mass kg; NULL where the
 * scene has none of this name. */
static const char *line_for(effect_scope *w, const char *called)
{
    const builder *b = w->b;
    const int *parameter = dictionary_find(&b->values.names, called), input = INDEX_OF(b->written->inputs, called);
    const int signal = INDEX_OF(b->written->signals, called);
    if (parameter == NULL && input < 0 && signal < 0) {
        return NULL;
    }
    const bool is_known = signal < 0 || w->signal_progress[signal] == DONE;
    const value one = {.count = 1, .dim = input >= 0 ? b->input_dimensions[input] : no_unit};
    const value is = parameter != NULL ? b->values.parameters[*parameter] : signal >= 0 ? w->signals[signal] : one;
    const char *unit_of_it = dimension_text(b->s->memory, is.dim);
    const char *in = !is_known                          ? " UNIT"
                     : dimension_equal(is.dim, no_unit) ? ""
                                                        : arena_format(b->s->memory, " %s", unit_of_it);
    return arena_format(b->s->memory, "%s %s%s%s%s", parameter != NULL ? "value" : "signal", called, in,
                        is.count == 3 ? " = (0, 0, 0)" : "", is.count == 3 ? in : "");
}

static void refuse_name(effect_scope *w, const formula *f)
{
    const char *line = line_for(w, f->name);
    if (line != NULL) {
        source_problem(w->b->s, f->at,
                       "this effect has no '%s', and sees of the scene what its use gives: write '%s' in its "
                       "definition, and '%s %s' in its use",
                       f->name, line, f->name, f->name);
        return;
    }
    source_problem(w->b->s, f->at, "this effect has no '%s': no operand, let, state or memory is called so%s", f->name,
                   suggestion(w->b->s, w->within->kind, f->name, EFFECT_JOINT, EFFECT_MEMORY));
}

static value output_of_effect(effect_scope *w, const formula *f, const char *dot);

/* Constants of the scene are known in definitions; tunables, inputs and signals a use gives. */
static bool is_constant_of_scene(const effect_scope *w, const char *called)
{
    const int *found = dictionary_find(&w->b->values.names, called);
    return found != NULL && !w->b->written->parameters.all[*found].tunable;
}

static bool find_in_instance(effect_scope *w, const formula *f, value *found)
{
    const char *dot = strrchr(f->name, '.');
    if (dot != NULL) {
        *found = output_of_effect(w, f, dot);
        return true;
    }
    if (find_argument(w, f->name, found)) {
        return true;
    }
    const effect_line *line = line_called(w->within->kind, f->name, false);
    if (line == NULL && find_limit(w, f->name, found)) {
        return true;
    }
    if (line == NULL && strcmp(f->name, "pi") != 0 && strcmp(f->name, "time") != 0) {
        unit u;
        if (unit_find(f->name, &u) || find_quantity(w, f, found)) {
            return !unit_find(f->name, &u);
        }
        if (is_constant_of_scene(w, f->name)) {
            return false;
        }
        refuse_name(w, f);
        *found = nothing;
        return true;
    }
    if (line != NULL) {
        const bool is_number = line->kind > EFFECT_BODY;
        *found = is_number ? line_value(w, w->within, line) : nothing;
        if (!is_number) {
            source_problem(w->b->s, f->at, "'%s' is a %s: write 'position of %s', say", f->name,
                           line->kind == EFFECT_JOINT ? "joint" : "body", f->name);
        }
    }
    return line != NULL;
}

/* EFFECT.OUTPUT; in a definition PART.OUTPUT. */
static value output_of_effect(effect_scope *w, const formula *f, const char *dot)
{
    source *s = w->b->s;
    const char *typed = arena_copy(s->memory, f->name, (size_t)(dot - f->name));
    const char *whole = whole_name(w, typed);
    FOR_ALL (const instance, in, w->all, w->b->written->effects.count) {
        const char *called = in->use->name.text;
        if (called == NULL || strcmp(called, whole) != 0) {
            continue;
        }
        if (in->kind == NULL || in->use->broken) {
            return nothing;
        }
        const effect_line *line = line_called(in->kind, dot + 1, true);
        if (line == NULL) {
            return REFUSED(s, f->at, "the effect '%s' has no output '%s'%s", called, dot + 1,
                           suggestion(s, in->kind, dot + 1, EFFECT_OUTPUT, EFFECT_OUTPUT));
        }
        value found = line_value(w, in, line);
        for (int part = 0; (in->use->left_out || in->use->dropped) && part < found.count; part++) {
            found.parts[part] = constant(w->b->g, 0.0);
        }
        return found;
    }
    if (w->within != NULL) {
        return REFUSED(s, f->at, "this effect has no part '%s'", typed);
    }
    return REFUSED(s, f->at, "no effect is called '%s'%s", typed, suggest_effect(s, w->b->written, typed));
}

static value input_value(effect_scope *w, int i)
{
    w->b->is_input_used[i] = true;
    if (!w->b->is_input_known[i]) {
        return nothing; /* its value is wrong, which was told */
    }
    return (value){.count = 1, .parts = {leaf(w->b->g, OP_INPUT, i)}, .dim = w->b->input_dimensions[i]};
}

/* The value of an input that only left-out effects read: zero, with its dimension. */
static value left_input_value(effect_scope *w, const quantity *q)
{
    values *v = &w->b->values;
    v->time_allowed = true;
    value found = q->has_unit || q->value == NULL ? (value){.count = 1, .dim = q->unit.dim} : value_any(v, q->value);
    v->time_allowed = false;
    found.parts[0] = constant(w->b->g, 0.0);
    return found;
}

value signal_value(effect_scope *w, size_t i)
{
    const quantity *q = &w->b->written->signals.all[i];
    const row_rate own = rate_of_block(w, NULL, q->block);
    if (w->signal_progress[i] == STARTED) {
        return refuse_loop(w, q->name.at, q->name.text);
    }
    if (w->signal_progress[i] == NOT_YET) {
        w->signal_progress[i] = STARTED;
        const row_rate before = pace(w, own);
        w->signals[i] = q->value == NULL ? nothing : evaluate(w, NULL, q->value, q->name.text);
        pace(w, before);
        w->signal_progress[i] = DONE;
    }
    if (!is_slow(own) || is_same_rate(own, w->rate)) {
        return w->signals[i];
    }
    return held_value(w, NULL, &w->signals[i], own, held_name(w->b->s->memory, NULL, q->name), q->name,
                      &w->held_signals[i]);
}

static bool find_in_scene(effect_scope *w, const formula *f, value *found)
{
    const scene *written = w->b->written;
    const char *dot = strrchr(f->name, '.');
    if (dot != NULL) {
        *found = output_of_effect(w, f, dot);
        return true;
    }
    const size_t inputs = written->inputs.count;
    const int input = index_called(written->inputs.all, inputs + written->left_input_count, sizeof(quantity), f->name);
    const int signal = INDEX_OF(written->signals, f->name);
    if (input >= 0) {
        *found = input < (int)inputs ? input_value(w, input) : left_input_value(w, &written->inputs.all[input]);
        return true;
    }
    if (signal >= 0) {
        *found = signal_value(w, (size_t)signal);
        return true;
    }
    const int mode = INDEX_OF(written->events.modes, f->name);
    if (mode >= 0) {
        *found = mode_value(w, (size_t)mode);
        return true;
    }
    return dictionary_find(&w->b->values.names, f->name) == NULL && find_quantity(w, f, found);
}

bool find_name(void *context, const formula *f, value *found)
{
    effect_scope *w = context;
    return w->within != NULL ? find_in_instance(w, f, found) : find_in_scene(w, f, found);
}
