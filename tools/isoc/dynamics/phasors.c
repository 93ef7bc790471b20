/* Nodes that turn with the positions: the sines and cosines of angles, and of their sums. */
#include "tools/isoc/dynamics/dynamics.h"

/* The phasor of p q + sign r s, with p' = a r, r' = -a p, q' = b s and s' = -b q: it changes by (a - sign b) (r q -
 * sign p s). The second factor is the other node, if it stands in the graph, up to its sign. */
static phasor phasor_of_products(graph *g, const phasor *all, size_t count, const node *pq, const node *rs, double sign)
{
    phasor result = {.other = -1};
    for (int swap = 0; swap < 2; swap++) {
        const node p = pq[0], q = pq[1], r = rs[swap], s = rs[1 - swap];
        if (all[p].other != r || all[q].other != s) {
            continue;
        }
        const node plus = mul(g, r, q), minus = mul(g, constant(g, sign), mul(g, p, s));
        const node other = sub(g, plus, minus), rate = sub(g, all[p].rate, mul(g, constant(g, sign), all[q].rate));
        const bool is_negative = g->nodes[other].op == OP_NEG;
        const node bare = is_negative ? g->nodes[other].a : other;
        if ((size_t)bare < count) {
            result = (phasor){.other = bare, .rate = is_negative ? neg(g, rate) : rate};
        }
    }
    return result;
}

static phasor phasor_of(graph *g, const node *along, const phasor *all, size_t count, node i)
{
    const graph_node n = g->nodes[i];
    const bool turns = (n.op == OP_SIN || n.op == OP_COS) && g->nodes[n.a].op == OP_STATE;
    if (turns) {
        const node by = along[g->nodes[n.a].index], other = n.op == OP_SIN ? cosine(g, n.a) : sine(g, n.a);
        return (phasor){other, n.op == OP_SIN ? by : neg(g, by)};
    }
    if (n.op == OP_MUL && is_constant(g, n.a) && all[n.b].other >= 0) {
        const node other = mul(g, n.a, all[n.b].other);
        return (phasor){(size_t)other < count ? other : -1, all[n.b].rate};
    }
    if ((n.op == OP_ADD || n.op == OP_SUB) && g->nodes[n.a].op == OP_MUL && g->nodes[n.b].op == OP_MUL) {
        const node pq[] = {g->nodes[n.a].a, g->nodes[n.a].b}, rs[] = {g->nodes[n.b].a, g->nodes[n.b].b};
        return phasor_of_products(g, all, count, pq, rs, n.op == OP_ADD ? 1.0 : -1.0);
    }
    return (phasor){.other = -1};
}

phasor *phasors_find(graph *g, const node *along, size_t count)
{
    phasor *all = arena_take(g->memory, count, sizeof *all);
    for (size_t i = 0; i < count; i++) {
        all[i] = phasor_of(g, along, all, count, (node)i);
    }
    return all;
}
