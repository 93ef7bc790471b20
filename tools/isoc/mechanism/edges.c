/* Jumps of a function of time at ticks that are known. */
#include "tools/isoc/mechanism/builder.h"

/* Steps, squares and sequences. Each counts once. */
void find_edges(builder *b, node drive)
{
    mechanism *m = &b->mechanism;
    const graph *g = b->g;
    bool *needed = arena_take(b->s->memory, g->count, sizeof *needed);
    graph_reach(g, &drive, 1, needed);
    for (size_t i = 0; i < g->count; i++) {
        const operation op = g->nodes[i].op;
        bool is_new = needed[i] && (op == OP_FROM || op == OP_SQUARE || op == OP_SQUARE_OF_PHASE || op == OP_PRBS);
        for (int k = 0; k < m->inputs.edge_count; k++) {
            is_new = is_new && m->inputs.edges[k] != (node)i;
        }
        if (is_new) {
            m->inputs.edges = arena_grow(b->s->memory, m->inputs.edges, (size_t)m->inputs.edge_count, &b->edge_room,
                                         sizeof *m->inputs.edges);
            m->inputs.edges[m->inputs.edge_count++] = (node)i;
        }
    }
}
