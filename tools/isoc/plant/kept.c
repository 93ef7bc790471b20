#include <string.h>

#include "tools/isoc/plant/plant.h"

/* Whether the last stage of a step has the factors of the projection behind it: it is so near to the end of the step
 * that with its factors a gap is left that is smaller by two orders of the step and more. Steps that prepare the next
 * one, a ladder, events and a second projection go without. */
static bool can_keep(const plant *p, const graph *g)
{
    const mechanism *m = p->m;
    return p->angles.count > 0 && p->after.factor_count > 0 && m->drift.projections == 1 &&
           m->policies.rung_count == 0 && !has_events(m) &&
           !uses_operation(g, p->outputs.roots, (size_t)p->outputs.count, OP_DERIVATIVE);
}

/* The values after the step, then the pivots. */
static node *all_after(const graph *g, const settled *after)
{
    const size_t count = (size_t)after->count, pivots = (size_t)after->pivot_count;
    node *result = arena_take(g->memory, count + pivots, sizeof *result);
    memcpy(result, after->values, count * sizeof *result);
    memcpy(result + count, after->pivots, pivots * sizeof *result);
    return result;
}

void keep_factors(plant *p, graph *g)
{
    settled *after = &p->after;
    if (!can_keep(p, g)) {
        return;
    }
    const size_t before = g->count, roots = (size_t)(after->count + after->pivot_count);
    node *to = all_nodes(g), *result = all_after(g, after);
    bool *is_read = arena_take(g->memory, before + (size_t)after->factor_count, sizeof *is_read);
    for (int i = 0; i < after->factor_count; i++) {
        to[after->factors[i]] = leaf(g, OP_KEPT, after->factors[i]);
    }
    replace_nodes(g, result, roots, before, to);
    mark_leaves(g, result, roots, OP_KEPT, is_read);
    after->kept = arena_take(g->memory, (size_t)after->factor_count, sizeof *after->kept);
    for (size_t i = 0; i < before; i++) {
        if (is_read[i]) {
            to[i] = leaf(g, OP_KEPT, after->kept_count);
            after->kept[after->kept_count++] = (node)i;
        }
    }
    replace_leaves(g, result, roots, OP_KEPT, to);
    after->values = result;
    after->pivots = result + after->count;
}
