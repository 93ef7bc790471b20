#include <math.h>
#include <string.h>

#include "tools/isoc/mechanism/builder.h"

static bool same_name(name a, name b)
{
    return a.text != NULL && b.text != NULL && strcmp(a.text, b.text) == 0;
}

void build_inputs(builder *b)
{
    mechanism *made = &b->made;
    made->input_count = (int)b->written->input_count;
    made->inputs = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->inputs);
    made->driven = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->driven);
    made->jumps = arena_take(b->s->memory, b->written->input_count + 1, sizeof *made->jumps);
    made->drives = arena_take(b->s->memory, b->written->input_count + (size_t)made->clocks.count + 1, sizeof(node));
    for (int i = 0; i < made->clocks.count; i++) {
        made->drives[made->input_count + i] = made->clocks.all[i].of_tick;
    }
    b->values.time_allowed = true;
    graph_section(b->g, "Inputs as functions of time");
    for (int i = 0; i < made->input_count; i++) {
        const quantity *q = &b->written->inputs[i];
        bool force = false, torque = false;
        for (size_t j = 0; j < b->written->joint_count; j++) {
            const joint *user = &b->written->joints[j];
            if (same_name(user->drive, q->name)) {
                force = force || user->kind == JOINT_PRISMATIC;
                torque = torque || user->kind == JOINT_REVOLUTE;
            }
        }
        for (size_t j = 0; j < b->written->force_count; j++) {
            force = force || same_name(b->written->forces[j].drive, q->name);
        }
        if (q->name.text == NULL || (!force && !torque && b->written->broken)) {
            continue;
        }
        if (!force && !torque) {
            source_problem(b->s, q->name.at, "the input '%s' is not used: write 'drive %s' in a joint or a force",
                           q->name.text, q->name.text);
        } else if (force && torque) {
            source_problem(b->s, q->name.at, "the input '%s' drives both a torque and a force: use two inputs",
                           q->name.text);
        }
        made->inputs[i] = (variable){.name = q->name.text,
                                     .unit = torque ? "N*m" : "N",
                                     .quote = source_quote(b->s, q->name.at),
                                     .least = -HUGE_VAL,
                                     .most = HUGE_VAL};
        made->driven[i] = q->value != NULL;
        const dimension effort = torque ? newton_metre : newton;
        const char *what = torque ? "a torque" : "a force";
        made->drives[i] = scalar_value(b, force || torque ? q->value : NULL, effort, what);
        made->jumps[i] =
            value_constant(&b->values, force || torque ? q->jump : NULL, effort, what, q->jump != NULL ? 1.0 : 0.0);
        if (q->jump != NULL && !(made->jumps[i] > 0.0)) {
            source_problem(b->s, q->jump->at, "a jump must be larger than zero");
        }
    }
    b->values.time_allowed = false;
}

/* A tunable parameter: its default must lie within its limits. */
static variable parameter_of(builder *b, const quantity *q, dimension of, double start)
{
    const bool is_plain = dimension_equal(of, no_unit);
    const char *what = arena_format(b->s->memory, "a limit of '%s'", q->name.text);
    variable made = {.name = q->name.text,
                     .unit = is_plain ? "1" : dimension_text(b->s->memory, of),
                     .quote = source_quote(b->s, q->name.at),
                     .least = value_constant(&b->values, q->least, of, what, -HUGE_VAL),
                     .most = value_constant(&b->values, q->most, of, what, HUGE_VAL),
                     .start = start};
    if (made.least > made.most) {
        source_problem(b->s, q->least->at, "the limits of '%s' are in the wrong order: in LEAST to MOST", q->name.text);
    } else if (start < made.least || start > made.most) {
        source_problem(b->s, q->value->at, "the default of '%s' is not within its limits", q->name.text);
    }
    return made;
}

void build_parameters(builder *b)
{
    const scene *written = b->written;
    mechanism *made = &b->made;
    made->parameters = arena_take(b->s->memory, written->parameter_count + 1, sizeof *made->parameters);
    made->defaults = b->values.defaults;
    for (size_t i = 0; i < written->parameter_count; i++) {
        const quantity *q = &written->parameters[i];
        const value *resolved = &b->values.parameters[i];
        if (q->tunable) {
            const int index = made->parameter_count++;
            made->parameters[index] = (variable){.name = q->name.text};
            if (resolved->count > 0) {
                made->parameters[index] = parameter_of(b, q, resolved->of, made->defaults[index]);
            }
        }
    }
}
