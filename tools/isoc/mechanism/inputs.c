#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

/* Finds the smooth inputs; the recipe says so if the method extrapolates them. */
static void build_smooth(builder *b)
{
    mechanism *m = &b->mechanism;
    bool any = false;
    m->inputs.smooth = arena_take(b->s->memory, (size_t)m->inputs.count + 1, sizeof *m->inputs.smooth);
    for (size_t i = 0; i < b->written->inputs.count; i++) {
        m->inputs.smooth[i] = b->written->inputs.all[i].smooth;
        any = any || m->inputs.smooth[i];
    }
    const unsigned smooth = m->method.recipe | ISO_SMOOTH;
    m->method.recipe = any && ISO_DEGREE(smooth) > 0 ? smooth : m->method.recipe;
}

/* The uses of an input by joints and forces: whether it is a torque, or a force. */
static void find_uses(const builder *b, name input, bool *force, bool *torque)
{
    *force = *torque = false;
    FOR_EACH (const joint, user, b->written->joints) {
        if (name_is(user->drive, input.text)) {
            const joint_kind part = joint_rows[user->kind].parts[0].kind;
            *force = *force || part == JOINT_PRISMATIC;
            *torque = *torque || part == JOINT_REVOLUTE;
        }
    }
    for (size_t j = 0; j < b->written->forces.count; j++) {
        *force = *force || name_is(b->written->forces.all[j].drive, input.text);
    }
}

/* The dimension of an input: that of the property that it drives, or its unit, or that of its value; else it is a plain
 * number. */
static dimension input_dimension(builder *b, const quantity *q, bool *is_known)
{
    bool force, torque;
    find_uses(b, q->name, &force, &torque);
    *is_known = true;
    if (force && torque) {
        source_problem(b->s, q->name.at, "the input '%s' drives both a torque and a force: use two inputs",
                       q->name.text);
    }
    const dimension driven = torque ? newton_metre : newton;
    if ((force || torque) && q->has_unit && !dimension_equal(q->unit.dim, driven)) {
        source_problem(b->s, q->name.at, "the input '%s' drives a %s, which is not in %s", q->name.text,
                       torque ? "torque" : "force", dimension_text(b->s->memory, q->unit.dim));
    }
    if (force || torque) {
        return driven;
    }
    const value v = q->has_unit || q->value == NULL ? nothing : value_any(&b->values, q->value);
    *is_known = q->has_unit || q->value == NULL || v.count == 1;
    return q->has_unit ? q->unit.dim : v.dim;
}

/* LEAST to MOST of a tunable or an input, in the right order. */
static void read_limits(builder *b, const quantity *q, bool is_known, dimension expected, variable *to)
{
    const char *what = arena_format(b->s->memory, "a limit of '%s'", q->name.text);
    to->least = value_constant(&b->values, is_known ? q->least : NULL, expected, what, -HUGE_VAL);
    to->most = value_constant(&b->values, is_known ? q->most : NULL, expected, what, HUGE_VAL);
    if (to->least > to->most) {
        source_problem(b->s, q->least->at, "the limits of '%s' are in the wrong order: in LEAST to MOST", q->name.text);
    }
}

/* The input as a wire, if it is one. */
static void build_wire(builder *b, int i, bool is_known, dimension expected)
{
    mechanism *m = &b->mechanism;
    const quantity *q = &b->written->inputs.all[i];
    const variable *v = &m->inputs.all[i];
    if (m->inputs.driven[i] && q->safe == NULL) {
        return;
    }
    wire *w = &m->inputs.wires[m->inputs.wire_count++];
    *w = (wire){.input = i};
    w->safe = value_constant(&b->values, is_known ? q->safe : NULL, expected,
                             arena_format(b->s->memory, "the safe value of '%s'", q->name.text), 0.0);
    w->after = whole_number(b, q->after, "the number of ticks", "", 0.0, 1.0, last_tick);
    if (q->safe != NULL && is_known && (w->safe < v->least || w->safe > v->most)) {
        source_problem(b->s, q->safe->at, "the safe value of '%s' is not within its limits", q->name.text);
    }
}

/* What an input is until one comes in: its value, where that is a constant; else zero, or the nearer limit. */
static void set_start(builder *b, const quantity *q, node drive, variable *v)
{
    const bool has_value = q->value != NULL && is_constant(b->g, drive);
    const double start = has_value ? constant_value(b->g, drive) : 0.0;
    v->start = fmin(fmax(start, v->least), v->most);
    if (has_value && v->least <= v->most && v->start != start) {
        source_problem(b->s, q->value->at, "the value of '%s' is not within its limits", q->name.text);
    }
}

static void build_input(builder *b, int i)
{
    mechanism *m = &b->mechanism;
    const quantity *q = &b->written->inputs.all[i];
    const dimension expected = input_dimension(b, q, &b->is_input_known[i]);
    const bool is_known = b->is_input_known[i];
    const char *what = dimension_equal(expected, newton_metre) ? "a torque"
                       : dimension_equal(expected, newton)     ? "a force"
                                                               : "this input";
    b->input_dimensions[i] = expected;
    m->inputs.all[i] = unlimited(q->name.text, dimension_unit(b->s->memory, expected), source_quote(b->s, q->name.at));
    read_limits(b, q, is_known, expected, &m->inputs.all[i]);
    m->inputs.drives[i] = scalar_value(b, is_known ? q->value : NULL, expected, what);
    m->inputs.driven[i] = q->value != NULL && !is_constant(b->g, m->inputs.drives[i]);
    set_start(b, q, m->inputs.drives[i], &m->inputs.all[i]);
    if (q->jump == NULL && !q->smooth) {
        find_edges(b, m->inputs.drives[i]);
    }
    m->inputs.jumps[i] =
        value_constant(&b->values, is_known ? q->jump : NULL, expected, what, q->jump != NULL ? 1.0 : 0.0);
    if (q->jump != NULL && !(m->inputs.jumps[i] > 0.0)) {
        source_problem(b->s, q->jump->at, "a jump must be larger than zero");
    }
    build_wire(b, i, is_known, expected);
}

void build_inputs(builder *b)
{
    mechanism *m = &b->mechanism;
    m->inputs.count = (int)b->written->inputs.count + b->time_input_count;
    const size_t room = (size_t)m->inputs.count + 1;
    m->inputs.all = arena_take(b->s->memory, room, sizeof *m->inputs.all);
    m->inputs.driven = arena_take(b->s->memory, room, sizeof *m->inputs.driven);
    m->inputs.jumps = arena_take(b->s->memory, room, sizeof *m->inputs.jumps);
    m->inputs.wires = arena_take(b->s->memory, room, sizeof *m->inputs.wires);
    m->inputs.drives = arena_take(b->s->memory, room + (size_t)m->clocks.count, sizeof *m->inputs.drives);
    b->input_dimensions = arena_take(b->s->memory, room, sizeof *b->input_dimensions);
    b->is_input_known = arena_take(b->s->memory, room, sizeof *b->is_input_known);
    b->is_input_used = arena_take(b->s->memory, room, sizeof *b->is_input_used);
    for (int i = 0; i < m->clocks.count; i++) {
        m->inputs.drives[m->inputs.count + i] = m->clocks.all[i].of_tick;
    }
    build_smooth(b);
    b->values.time_allowed = true;
    graph_section(b->g, "Inputs as functions of time");
    for (size_t i = 0; i < b->written->inputs.count; i++) {
        if (b->written->inputs.all[i].name.text != NULL) {
            build_input(b, (int)i);
        }
    }
    b->values.time_allowed = false;
}

void check_inputs(builder *b)
{
    for (size_t i = 0; i < b->written->inputs.count && !b->is_effect_broken; i++) {
        const name input = b->written->inputs.all[i].name;
        bool force, torque;
        find_uses(b, input, &force, &torque);
        if (input.text != NULL && !b->written->broken && !force && !torque && !b->is_input_used[i]) {
            source_problem(
                b->s, input.at,
                "the input '%s' is not used: write 'drive %s' in a joint or a force, or give it to an effect",
                input.text, input.text);
        }
    }
}

/* A tunable parameter: its default must lie within its limits. */
static variable parameter_of(builder *b, const quantity *q, dimension expected, double start)
{
    variable result = unlimited(q->name.text, dimension_unit(b->s->memory, expected), source_quote(b->s, q->name.at));
    result.dimension = expected;
    result.start = start;
    read_limits(b, q, true, expected, &result);
    if (result.least <= result.most && (start < result.least || start > result.most)) {
        source_problem(b->s, q->value->at, "the default of '%s' is not within its limits", q->name.text);
    }
    return result;
}

void build_parameters(builder *b)
{
    const scene *written = b->written;
    mechanism *m = &b->mechanism;
    const size_t room = written->parameters.count + b->faults.count + 1;
    m->parameters.all = arena_take(b->s->memory, room, sizeof *m->parameters.all);
    m->parameters.is_built_in = arena_take(b->s->memory, room, sizeof *m->parameters.is_built_in);
    m->parameters.defaults = b->values.defaults;
    for (size_t i = 0; i < written->parameters.count; i++) {
        const quantity *q = &written->parameters.all[i];
        const value *resolved = &b->values.parameters[i];
        if (q->tunable) {
            const int index = m->parameters.count++;
            m->parameters.all[index] = (variable){.name = q->name.text};
            if (resolved->count > 0) {
                m->parameters.all[index] = parameter_of(b, q, resolved->dim, m->parameters.defaults[index]);
            }
        }
    }
    FOR_EACH (const variable, fault, b->faults) {
        m->parameters.all[m->parameters.count++] = *fault;
    }
}
