/* Jumps of a function of time at ticks that are known. */
#include "tools/isoc/mechanism/builder.h"

/* Steps, squares and sequences. Each counts once. */
void find_edges(builder *b, node drive)
{
    mechanism *m = &b->mechanism;
    for (reached r = reach(b->g, &drive, 1); reach_next(&r);) {
        const operation op = r.n->op;
        bool is_new = op == OP_FROM || op == OP_SQUARE || op == OP_SQUARE_OF_PHASE || op == OP_PRBS;
        for (int k = 0; k < m->inputs.edge_count; k++) {
            is_new = is_new && m->inputs.edges[k] != r.at;
        }
        if (is_new) {
            ADD_TO(b->s->memory, m->inputs.edges, m->inputs.edge_count, b->edge_room, r.at);
        }
    }
}
