#include "tools/isoc/emit/parts.h"

/* `function` of each rung, the topmost first: that of its reduced plant. */
static void emit_table_of_rungs(emission *e, const char *type, const char *function)
{
    const policies *how = &e->p->m->policies;
    put(e, "static %s (*const %s_of_rungs[])(void *memory) = {%s", type, function, function);
    for (int i = 0; i < how->rung_count; i++) {
        const reduced_plant *left = reduced_plant_on_rung(e->p, i);
        put(e, ", %s%s", function, left == NULL ? "" : left->suffix);
    }
    put(e, "};\n\n");
}

/* The parts of a tick that depend on the rung: the step; and where effects are dropped, the functions after it. The
 * rung changes only after all of these. */
static void emit_rungs(emission *e, const char *counts)
{
    put(e, "static bool attempt(const iso_plant *const plant)\n{\n");
    put(e, "    return iso_policy_attempt(plant, ladder[(%s)->rung]);\n}\n\n", counts);
    if (e->p->reduced_plant_count > 0) {
        emit_table_of_rungs(e, "uint32_t", "finish");
        emit_table_of_rungs(e, "void", "output");
        put(e, "static uint32_t finish_on_rung(void *const instance)\n{\n");
        put(e, "    return finish_of_rungs[(%s)->rung](instance);\n}\n\n", counts);
        put(e, "static void output_on_rung(void *const instance)\n{\n");
        put(e, "    output_of_rungs[(%s)->rung](instance);\n}\n\n", counts);
    }
}

void emit_policies(emission *e)
{
    const policies *how = &e->p->m->policies;
    const char *counts = how->histogram ? "&policed.counts" : "&policed";
    put(e, "/* What the scene asks for about ticks that do not keep their time. */\n");
    put(e, "static %s policed = {%s.latency = %d%s};\n\n",
        how->histogram ? "iso_policy_histogram" : "iso_policy_counts", how->histogram ? ".counts = {" : "",
        how->delayed ? 1 : 0, how->histogram ? "}" : "");
    put(e, "static bool account(iso_loop *const loop, const iso_news *const news)\n{\n");
    put_if(e, how->grace > 0.0, "    iso_policy_grace(loop, %s, news, UINT32_C(%.0f));\n", counts, how->grace);
    put_if(e, how->histogram, "    iso_policy_bin(loop, &policed, news);\n");
    put_if(e, how->overrun == OVERRUN_CATCH_UP, "    iso_policy_catch_up(loop, %s, UINT32_C(%.0f));\n", counts,
           how->catch_up);
    put_if(e, how->overrun == OVERRUN_DEGRADE,
           "    iso_policy_degrade(loop, %s, news, UINT32_C(%.0f), %d, UINT32_C(%.0f));\n", counts, how->grace,
           how->rung_count, how->after);
    put_if(e, how->overrun != OVERRUN_STOP && how->overrun != OVERRUN_DEGRADE && !(how->grace > 0.0) && !how->histogram,
           "%s    (void)news;\n", how->overrun == OVERRUN_CATCH_UP ? "" : "    (void)loop;\n");
    if (how->overrun == OVERRUN_STOP) {
        put(e, "    return iso_policy_stop(loop, %s, news, UINT32_C(%.0f));\n}\n\n", counts, how->grace);
    } else {
        put(e, "    return true;\n}\n\n");
    }
    put(e,
        "static const iso_policy policy = {\n    .account = account,\n    .counts = %s,\n"
        "    .count = sizeof policed / sizeof(uint64_t),\n    .rungs = %d,\n    .delays = %s,\n};\n\n",
        counts, how->overrun == OVERRUN_DEGRADE ? how->rung_count : 0, how->delayed ? "true" : "false");
    if (how->overrun == OVERRUN_DEGRADE) {
        emit_rungs(e, counts);
    }
}
