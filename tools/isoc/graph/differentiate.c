#include "tools/isoc/graph/differentiate.h"

void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives)
{
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    const size_t before = g->count; /* what is made on the way is not differentiated */
    bool *needed = arena_take(g->memory, before, sizeof *needed);
    node *d = arena_take(g->memory, before, sizeof *d);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        const graph_node n = g->nodes[i];
        d[i] = (node)i == by ? one : zero;
        if (needed[i] && operators[n.op].operands > 0) {
            d[i] = operators[n.op].derivative(g, (node)i, d[n.a], d[n.b]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        derivatives[i] = d[roots[i]];
    }
    arena_return(g->memory, needed, before, sizeof *needed);
    arena_return(g->memory, d, before, sizeof *d);
}

/* Makes the roots anew of what stands in the place of each leaf: to[g->count]. */
static void rebuild(graph *g, node *roots, size_t count, node *to)
{
    const size_t before = g->count;
    bool *needed = arena_take(g->memory, before, sizeof *needed);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        const graph_node n = g->nodes[i];
        const operator_row *row = &operators[n.op];
        if (needed[i] && row->operands > 0) {
            const node a = to[n.a], b = row->operands == 2 ? to[n.b] : n.b;
            to[i] = a == n.a && b == n.b ? (node)i : row->again(g, a, b);
        }
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = to[roots[i]];
    }
    arena_return(g->memory, needed, before, sizeof *needed);
}

void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by)
{
    const size_t before = g->count;
    node *to = arena_take(g->memory, before, sizeof *to);
    for (size_t i = 0; i < before; i++) {
        to[i] = g->nodes[i].op == op ? by[g->nodes[i].index] : (node)i;
    }
    rebuild(g, roots, count, to);
    arena_return(g->memory, to, before, sizeof *to);
}

node replace_leaf(graph *g, node root, node leaf, node by)
{
    const size_t before = g->count;
    node *to = arena_take(g->memory, before, sizeof *to);
    for (size_t i = 0; i < before; i++) {
        to[i] = (node)i == leaf ? by : (node)i;
    }
    rebuild(g, &root, 1, to);
    arena_return(g->memory, to, before, sizeof *to);
    return root;
}
