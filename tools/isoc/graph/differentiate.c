#include "tools/isoc/graph/differentiate.h"

/* The rules of differentiation; da and db are the derivatives of the operands. */
static node derivative_of(graph *g, node i, node da, node db)
{
    const graph_node n = g->nodes[i];
    switch (n.op) {
    case OP_ADD:
        return add(g, da, db);
    case OP_SUB:
        return sub(g, da, db);
    case OP_MUL:
        return sum_of_products(g, da, n.b, n.a, db);
    case OP_DIV: { /* (a / b)' = (a' - (a / b) b') / b, with one division for all derivatives */
        const node above = sub(g, da, mul(g, i, db)), inverse = divide(g, constant(g, 1.0), n.b);
        return mul(g, above, inverse);
    }
    case OP_MAX: { /* that of the larger */
        const node of_a = mul(g, above(g, n.a, n.b), da), of_b = mul(g, above(g, n.b, n.a), db);
        return add(g, of_a, of_b);
    }
    case OP_WRAP:
        return da;
    case OP_NEG:
        return neg(g, da);
    case OP_SIN:
        return mul(g, cosine(g, n.a), da);
    case OP_COS:
        return neg(g, mul(g, sine(g, n.a), da));
    default:
        return constant(g, 0.0);
    }
}

void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives)
{
    const size_t before = g->count; /* what is made on the way is not differentiated */
    const node zero = constant(g, 0.0), one = constant(g, 1.0);
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    node *d = arena_take(g->memory, g->count, sizeof *d);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        d[i] = (node)i == by ? one : zero;
        if (needed[i] && g->nodes[i].op >= OP_ADD) {
            d[i] = derivative_of(g, (node)i, d[g->nodes[i].a], d[g->nodes[i].b]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        derivatives[i] = d[roots[i]];
    }
}

/* The same operation on other operands. */
static node remake(graph *g, graph_node n, node a, node b)
{
    switch (n.op) {
    case OP_ADD:
        return add(g, a, b);
    case OP_SUB:
        return sub(g, a, b);
    case OP_MUL:
        return mul(g, a, b);
    case OP_DIV:
        return divide(g, a, b);
    case OP_NEG:
        return neg(g, a);
    case OP_SIN:
        return sine(g, a);
    case OP_COS:
        return cosine(g, a);
    case OP_MAX:
        return larger(g, a, b);
    case OP_ABOVE:
        return above(g, a, b);
    case OP_WRAP:
        return wrap(g, a);
    default:
        return magnitude(g, a);
    }
}

/* Makes the roots anew of what stands in the place of each leaf: to[g->count]. */
static void rebuild(graph *g, node *roots, size_t count, node *to)
{
    const size_t before = g->count;
    bool *needed = arena_take(g->memory, before, sizeof *needed);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        const graph_node n = g->nodes[i];
        if (needed[i] && n.op >= OP_ADD) {
            const node a = to[n.a], b = n.op <= OP_DIV ? to[n.b] : n.b;
            to[i] = a == n.a && b == n.b ? (node)i : remake(g, n, a, b);
        }
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = to[roots[i]];
    }
}

void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by)
{
    node *to = arena_take(g->memory, g->count, sizeof *to);
    for (size_t i = 0; i < g->count; i++) {
        to[i] = g->nodes[i].op == op ? by[g->nodes[i].index] : (node)i;
    }
    rebuild(g, roots, count, to);
}

node replace_leaf(graph *g, node root, node leaf, node by)
{
    node *to = arena_take(g->memory, g->count, sizeof *to);
    for (size_t i = 0; i < g->count; i++) {
        to[i] = (node)i == leaf ? by : (node)i;
    }
    rebuild(g, &root, 1, to);
    return root;
}
