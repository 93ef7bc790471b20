#include "tools/isoc/plant/plant.h"

fast_part fast_build(const graph *g, const mechanism *m, const node *derivatives)
{
    const size_t states = (size_t)state_count(m);
    fast_part result = {0};
    if (m->effects.fast_substeps == 0) {
        return result;
    }
    result.states = arena_take(g->memory, states, sizeof *result.states);
    result.reads = arena_take(g->memory, states, sizeof *result.reads);
    result.derivatives = arena_take(g->memory, states, sizeof *result.derivatives);
    for (int i = 0; i < (int)states; i++) {
        if (is_fast_state(m, i)) {
            result.derivatives[result.count] = derivatives[i];
            result.states[result.count++] = i;
        }
    }
    bool *reads = arena_take(g->memory, states, sizeof *reads);
    mark_leaves(g, result.derivatives, (size_t)result.count, OP_STATE, reads);
    for (int i = 0; i < (int)states; i++) {
        if (reads[i] && !is_fast_state(m, i)) {
            result.reads[result.read_count++] = i;
        }
    }
    return result;
}
