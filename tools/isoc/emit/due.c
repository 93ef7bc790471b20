/* The rows that are due. A plant counts the rows of each period: memory->in_5 is the number of the row modulo 5. What
 * branches on it follows from the number of the tick alone. */
#include "tools/isoc/emit/parts.h"

static void add_period(const emission *e, period_list *to, row_rate rate)
{
    bool is_new = is_slow(rate);
    FOR_EACH (const double, period, *to) {
        is_new = is_new && (*period < rate.every || *period > rate.every);
    }
    if (is_new) {
        LIST_ADD(e->out->memory, *to, rate.every);
    }
}

period_list periods_of(const emission *e)
{
    const mechanism *m = e->p->m;
    period_list all = {0};
    FOR_ALL (const effect_quantity, q, m->effects.memories, m->effects.memory_count) {
        add_period(e, &all, q->rate);
    }
    FOR_ALL (const shown, o, m->outputs, m->output_count) {
        add_period(e, &all, o->rate);
    }
    return all;
}

const char *due_condition(const emission *e, row_rate rate)
{
    return form(e, "memory->in_%.0f == %.0f", rate.every, rate.phase);
}

void put_when_due(const emission *e, row_rate rate, const char *statement)
{
    put_if(e, is_slow(rate), "    if (%s) {\n    ", due_condition(e, rate));
    put(e, "    %s\n", statement);
    put_if(e, is_slow(rate), "    }\n");
}

void emit_next_row(const emission *e)
{
    const period_list all = periods_of(e);
    put(e, "    memory->row++;\n");
    FOR_EACH (const double, period, all) {
        put(e, "    memory->in_%.0f = memory->in_%.0f < %.0f ? memory->in_%.0f + 1 : 0;\n", *period, *period,
            *period - 1.0, *period);
    }
}

void emit_row(const emission *e, const char *indent, const char *row)
{
    const period_list all = periods_of(e);
    put(e, "%smemory->row = %s;\n", indent, row);
    FOR_EACH (const double, period, all) {
        put(e, "%smemory->in_%.0f = iso_tick_modulo(%s, UINT32_C(%.0f));\n", indent, *period, row, *period);
    }
}
