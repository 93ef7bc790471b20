#include "tools/isoc/plant/fast.h"

fast_part fast_build(const graph *g, const mechanism *m, const node *derivatives)
{
    const size_t states = (size_t)state_count(m);
    fast_part made = {0};
    if (m->fast_substeps == 0) {
        return made;
    }
    made.states = arena_take(g->memory, states, sizeof *made.states);
    made.reads = arena_take(g->memory, states, sizeof *made.reads);
    made.derivatives = arena_take(g->memory, states, sizeof *made.derivatives);
    for (int i = 0; i < (int)states; i++) {
        if (is_fast_state(m, i)) {
            made.derivatives[made.count] = derivatives[i];
            made.states[made.count++] = i;
        }
    }
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, made.derivatives, (size_t)made.count, needed);
    bool *reads = arena_take(g->memory, states, sizeof *reads);
    for (size_t i = 0; i < g->count; i++) {
        if (needed[i] && g->nodes[i].op == OP_STATE) {
            reads[g->nodes[i].index] = true;
        }
    }
    for (int i = 0; i < (int)states; i++) {
        if (reads[i] && !is_fast_state(m, i)) {
            made.reads[made.read_count++] = i;
        }
    }
    return made;
}
