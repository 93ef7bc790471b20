#include "tools/isoc/emit/parts.h"

/* static const real ARRAY[CART_WHAT] = {[PLACE] = NUMBER, ...}; */
static void begin_array(emission *e, const char *array, const char *what)
{
    put(e, "static const real %s[$C_%s] = {\n", array, what);
}

static void add_entry(emission *e, const leaf_name *leaf, const char *number)
{
    put(e, "    [%s] = %s,\n", leaf->place, number);
}

void emit_limits(emission *e, const char *array, const char *what, const leaf_name *leaves, const variable *all,
                 int count)
{
    if (!has_limits(all, count)) {
        return;
    }
    put(e, "static const iso_limits %s[$C_%s] = {\n", array, what);
    for (int i = 0; i < count; i++) {
        add_entry(e, &leaves[i], form(e, "{%s, %s}", limit(e, all[i].least), limit(e, all[i].most)));
    }
    put(e, "};\n\n");
}

void emit_data(emission *e)
{
    const mechanism *m = e->p->m;
    begin_array(e, "start", "STATES");
    for (int i = 0; i < state_count(m); i++) {
        add_entry(e, &e->names->leaves.states[i], literal(e, e->names->states[i].about.start));
    }
    put(e, "};\n\n");
    if (has_range(e)) {
        put(e, "/* How large each state may be, for the guard. */\n");
        begin_array(e, "range", "STATES");
        for (int i = 0; i < state_count(m); i++) {
            const state *s = &e->names->states[i];
            add_entry(e, &e->names->leaves.states[i], is_limited(s) ? "ISO_ANGLE_RANGE" : "ISO_REAL_MAX");
        }
        put(e, "};\n\n");
    }
    if (m->parameters.count > 0) {
        begin_array(e, "defaults", "PARAMETERS");
        for (int i = 0; i < m->parameters.count; i++) {
            add_entry(e, &e->names->leaves.parameters[i], literal(e, m->parameters.all[i].start));
        }
        put(e, "};\n\n");
    }
    emit_limits(e, "input_limits", "INPUTS", e->names->leaves.inputs, m->inputs.all, m->inputs.count);
    emit_limits(e, "parameter_limits", "PARAMETERS", e->names->leaves.parameters, m->parameters.all,
                m->parameters.count);
}
