#include "tools/isoc/plant/plant.h"

bool has_slow_memories(const mechanism *m)
{
    bool any = false;
    FOR_ALL (const effect_quantity, e, m->effects.memories, m->effects.memory_count) {
        any = any || is_slow(e->rate);
    }
    return any;
}

const char *rate_words(arena *memory, row_rate rate)
{
    return rate.phase > 0.0 ? arena_format(memory, "every_%.0f_at_%.0f", rate.every, rate.phase)
                            : arena_format(memory, "every_%.0f", rate.every);
}

static operations *cost_at(rate_costs *all, row_rate rate, arena *memory)
{
    FOR_EACH (rate_cost, c, *all) {
        if (is_same_rate(c->rate, rate)) {
            return &c->in_a_row;
        }
    }
    LIST_ADD(memory, *all, ((rate_cost){.rate = rate}));
    return &all->all[all->count - 1].in_a_row;
}

/* Of these formulas; one that reads an acceleration evaluates the derivative. */
static operations cost_of(const plant *p, const graph *g, const node *roots, size_t count)
{
    const operations derivative = count_operations(g, p->derivatives, (size_t)state_count(p->m));
    return operations_plus(count_operations(g, roots, count), uses_operation(g, roots, count, OP_DERIVATIVE),
                           derivative);
}

/* Of the memories that are set in rows of this rate. */
static operations cost_of_memories(const plant *p, const graph *g, row_rate rate)
{
    const effect_set *all = &p->m->effects;
    node *roots = arena_take(g->memory, (size_t)all->memory_count + 1, sizeof *roots);
    size_t count = 0;
    FOR_ALL (const effect_quantity, e, all->memories, all->memory_count) {
        if (is_same_rate(e->rate, rate)) {
            roots[count++] = e->next;
        }
    }
    return cost_of(p, g, roots, count);
}

rate_costs rate_costs_of(const plant *p, const graph *g, arena *memory)
{
    rate_costs all = {0};
    const output_rates outputs = output_rates_of(p, memory);
    (void)cost_at(&all, each_row, memory);
    FOR_ALL (const effect_quantity, e, p->m->effects.memories, p->m->effects.memory_count) {
        (void)cost_at(&all, e->rate, memory);
    }
    FOR_EACH (const output_rate, o, outputs) {
        (void)cost_at(&all, o->rate, memory);
    }
    FOR_EACH (rate_cost, c, all) {
        c->in_a_row = cost_of_memories(p, g, c->rate);
    }
    FOR_EACH (const output_rate, o, outputs) {
        operations *to = cost_at(&all, o->rate, memory);
        *to = operations_plus(*to, 1, cost_of(p, g, o->roots, (size_t)o->count));
    }
    return all;
}

/* What is due in a row. */
static operations work_of(const rate_costs *all, long row)
{
    operations work = {0};
    FOR_EACH (const rate_cost, c, *all) {
        const bool is_due = row % (long)c->rate.every == (long)c->rate.phase;
        work = operations_plus(work, is_due, c->in_a_row);
    }
    return work;
}

dearest_row dearest_row_of(const rate_costs *all)
{
    enum { SINE = 36 }; /* cycles_of leaves out */
    dearest_row best = {1.0, work_of(all, 1)};
    for (long row = 2; row <= MOST_ROWS; row++) {
        const operations work = work_of(all, row);
        if (cycles_of(work) + SINE * work.sincos > cycles_of(best.in_it) + SINE * best.in_it.sincos) {
            best = (dearest_row){(double)row, work};
        }
    }
    return best;
}
