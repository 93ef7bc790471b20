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

static bool is_limited(const state *s)
{
    return !isinf(s->about.most);
}

bool has_range(const emission *e)
{
    bool any = false;
    for (int i = 0; i < state_count(e->p->m); i++) {
        any = any || is_limited(&e->names->states[i]);
    }
    return any;
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
    if (m->memory_count > 0) {
        text_add(e->out, "static const real memory_start[] = {\n");
        for (int i = 0; i < m->memory_count; i++) {
            text_add(e->out, "    %s,\n", literal(e, m->memories[i].about.start));
        }
        text_add(e->out, "};\n\n");
    }
    if (m->parameter_count > 0) {
        begin_array(e, "defaults", "PARAMETERS");
        for (int i = 0; i < m->parameter_count; i++) {
            add_entry(e, &e->names->leaves.parameters[i], literal(e, m->parameters[i].start));
        }
        text_add(e->out, "};\n\n");
    }
}
