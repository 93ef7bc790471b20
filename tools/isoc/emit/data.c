#include "tools/isoc/emit/parts.h"

#include <math.h>

#include "tools/isoc/graph/timed.h"

/* These numbers of a table; or where they are NULL, its words. */
static void emit_entries(emission *e, const char *called, int i, const tick_table *t, const double *numbers)
{
    enum { IN_A_LINE = 7 };
    put(e, "static const %s %s_%d[%zu] = {", numbers == NULL ? "uint32_t" : table_type(e), called, i, t->count);
    for (size_t k = 0; k < t->count; k++) {
        put(e, "%s%s,", k % IN_A_LINE == 0 ? "\n    " : " ",
            numbers == NULL ? form(e, "UINT32_C(%u)", (unsigned)t->words[k]) : table_literal(e, numbers[k]));
    }
    put(e, "\n};\n");
}

static void emit_lines(emission *e, int i, const tick_table *t)
{
    emit_entries(e, "first", i, t, NULL);
    emit_entries(e, "value", i, t, t->values);
    emit_entries(e, "slope", i, t, t->slopes);
    put(e, "static const iso_lines lines_%d = {first_%d, value_%d, slope_%d, %zu};\n\n", i, i, i, i, t->count);
}

static void emit_chirp(emission *e, int i, const tick_table *t)
{
    const iso_chirp_table sweep = sweep_of(t);
    arena *memory = e->out->memory;
    put(e, "static const iso_chirp_table chirp_%d = {\n    .first = %s,\n    .last = %s,\n", i,
        code_phase(memory, t->first), code_phase(memory, t->last));
    put(e, "    .curve = UINT64_C(0x%016llX),\n    .sign = %s,\n    .shift = %d,\n    .ticks = UINT32_C(%.0f),\n};\n\n",
        (unsigned long long)sweep.curve, sweep.sign != 0 ? "~UINT64_C(0)" : "0", (int)sweep.shift, t->ticks);
}

void emit_tick_tables(emission *e, const node *roots, size_t count)
{
    const tick_table *tables = e->g->tables->all;
    for (reached r = reach(e->g, roots, count); reach_next(&r);) {
        const int i = r.n->index;
        if (r.n->op == OP_PRBS) {
            emit_entries(e, "prbs", i, &tables[i], NULL);
            put(e, "\n");
        } else if (r.n->op == OP_CHIRP) {
            emit_chirp(e, i, &tables[i]);
        } else if (r.n->op == OP_LINES) {
            emit_lines(e, i, &tables[i]);
        }
    }
}

static void begin_array(emission *e, const char *array, const char *what)
{
    put(e, "static const %s %s[$C_%s] = {\n", table_type(e), array, what);
}

static void add_entry(emission *e, const leaf_name *leaf, const char *number)
{
    put(e, "    [%s] = %s,\n", leaf->place, number);
}

/* static const real ARRAY[CART_WHAT] = {[PLACE] = NUMBER, ...}; with the values at the start. */
static void emit_starts(emission *e, const char *array, const char *what, const quantities *content)
{
    begin_array(e, array, what);
    for (int i = 0; i < content->count; i++) {
        add_entry(e, &content->leaves[i], table_literal(e, content->all[i].start));
    }
    put(e, "};\n\n");
}

void emit_limits(emission *e, const char *array, const char *what, const quantities *content)
{
    if (!has_limits(content)) {
        return;
    }
    put(e, "static const iso_limits %s[$C_%s] = {\n", array, what);
    for (int i = 0; i < content->count; i++) {
        add_entry(e, &content->leaves[i],
                  form(e, "{%s, %s}", limit(e, content->all[i].least), limit(e, content->all[i].most)));
    }
    put(e, "};\n\n");
}

void emit_data(emission *e)
{
    const quantities *x = &e->names->x, *p = &e->names->p;
    emit_starts(e, "start", "STATES", x);
    if (has_limits(x)) {
        put(e, "/* How large each state may be, for the guard. */\n");
        begin_array(e, "range", "STATES");
        for (int i = 0; i < x->count; i++) {
            add_entry(e, &x->leaves[i], isinf(x->all[i].most) ? "ISO_REAL_MAX" : "ISO_ANGLE_RANGE");
        }
        put(e, "};\n\n");
    }
    if (p->count > 0) {
        emit_starts(e, "defaults", "PARAMETERS", p);
    }
    emit_limits(e, "input_limits", "INPUTS", &e->names->u);
    emit_limits(e, "parameter_limits", "PARAMETERS", p);
}
