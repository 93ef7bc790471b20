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
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, result.derivatives, (size_t)result.count, needed);
    bool *reads = arena_take(g->memory, states, sizeof *reads);
    for (size_t i = 0; i < g->count; i++) {
        if (needed[i] && g->nodes[i].op == OP_STATE) {
            reads[g->nodes[i].index] = true;
        }
    }
    for (int i = 0; i < (int)states; i++) {
        if (reads[i] && !is_fast_state(m, i)) {
            result.reads[result.read_count++] = i;
        }
    }
    return result;
}
