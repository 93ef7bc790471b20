#include <math.h>

#include "tools/isoc/emit/parts.h"

/* static const real ARRAY[CART_WHAT] = {[PLACE] = NUMBER, ...}; */
static void begin_array(emission *e, const char *array, const char *what)
{
    text_add(e->out, "static const real %s[%s_%s] = {\n", array, e->names->capitals, what);
}

static void add_entry(emission *e, const leaf_name *leaf, const char *number)
{
    text_add(e->out, "    [%s] = %s,\n", leaf->place, number);
}

static const char *literal(const emission *e, double number)
{
    return code_literal(e->out->memory, number, e->p->is_double);
}

void emit_limits(emission *e, const char *array, const char *what, const leaf_name *leaves, const variable *all,
                 int count)
{
    if (!has_limits(all, count)) {
        return;
    }
    text_add(e->out, "static const iso_limits %s[%s_%s] = {\n", array, e->names->capitals, what);
    for (int i = 0; i < count; i++) {
        const variable *v = &all[i];
        add_entry(e, &leaves[i],
                  arena_format(e->out->memory, "{%s, %s}", isinf(v->least) ? "-ISO_REAL_MAX" : literal(e, v->least),
                               isinf(v->most) ? "ISO_REAL_MAX" : literal(e, v->most)));
    }
    text_add(e->out, "};\n\n");
}

void emit_data(emission *e)
{
    const mechanism *m = e->p->m;
    begin_array(e, "start", "STATES");
    for (int i = 0; i < state_count(m); i++) {
        add_entry(e, &e->names->leaves.states[i], literal(e, e->names->states[i].about.start));
    }
    text_add(e->out, "};\n\n");
    if (has_range(e)) {
        text_add(e->out, "/* How large each state may be, for the guard. */\n");
        begin_array(e, "range", "STATES");
        for (int i = 0; i < state_count(m); i++) {
            const state *s = &e->names->states[i];
            add_entry(e, &e->names->leaves.states[i], is_limited(s) ? "ISO_ANGLE_RANGE" : "ISO_REAL_MAX");
        }
        text_add(e->out, "};\n\n");
    }
    if (m->parameters.count > 0) {
        begin_array(e, "defaults", "PARAMETERS");
        for (int i = 0; i < m->parameters.count; i++) {
            add_entry(e, &e->names->leaves.parameters[i], literal(e, m->parameters.all[i].start));
        }
        text_add(e->out, "};\n\n");
    }
    emit_limits(e, "input_limits", "INPUTS", e->names->leaves.inputs, m->inputs.all, m->inputs.count);
    emit_limits(e, "parameter_limits", "PARAMETERS", e->names->leaves.parameters, m->parameters.all,
                m->parameters.count);
}
