#include "tools/isoc/plant/plant.h"

#include "tools/isoc/graph/rules.h"

/* Which nodes of a growing graph follow from tunables and constants alone. */
typedef struct tuned {
    graph *g;
    bool *is;
    size_t count, room;
} tuned;

static bool is_tuned(tuned *t, node n)
{
    const graph *g = t->g;
    for (; t->count < g->count; t->count++) {
        const graph_node *at = &g->nodes[t->count];
        const int operands = operators[at->op].operands;
        t->is = arena_grow(g->memory, t->is, t->count, &t->room, sizeof *t->is);
        t->is[t->count] = operands == 0 ? at->op == OP_PARAMETER || at->op == OP_CONSTANT
                                        : t->is[at->a] && (operands == 1 || t->is[at->b]);
    }
    return t->is[n];
}

/* A node as what follows from tunables, times the rest. */
typedef struct product {
    node tuned, rest;
} product;

static product split(tuned *t, node n)
{
    graph *g = t->g;
    product p = {constant(g, 1.0), n};
    for (;;) {
        const graph_node at = g->nodes[p.rest];
        if (at.op == OP_NEG) {
            p = (product){neg(g, p.tuned), at.a};
        } else if (at.op == OP_MUL && is_tuned(t, at.a)) {
            p = (product){mul(g, p.tuned, at.a), at.b};
        } else if (at.op == OP_MUL && is_tuned(t, at.b)) {
            p = (product){mul(g, p.tuned, at.b), at.a};
        } else {
            return p;
        }
    }
}

static bool is_one(const graph *g, node n)
{
    return is_constant(g, n) && constant_value(g, n) == 1.0;
}

static node product_of(tuned *t, node a, node b)
{
    graph *g = t->g;
    if (is_tuned(t, a) && is_tuned(t, b)) {
        return mul(g, a, b);
    }
    const product pa = is_tuned(t, a) ? (product){a, constant(g, 1.0)} : split(t, a);
    const product pb = is_tuned(t, b) ? (product){b, constant(g, 1.0)} : split(t, b);
    if (is_one(g, pa.tuned) || is_one(g, pb.tuned)) {
        return mul(g, a, b);
    }
    const node of_both = mul(g, pa.tuned, pb.tuned), rest = mul(g, pa.rest, pb.rest);
    return mul(g, of_both, rest);
}

static node again(tuned *t, const graph_node *n, node a, node b)
{
    graph *g = t->g;
    if (n->op == OP_MUL) {
        return product_of(t, a, b);
    }
    if (n->op == OP_DIV && is_tuned(t, b) && !is_tuned(t, a)) {
        return product_of(t, divide(g, constant(g, 1.0), b), a);
    }
    return a == n->a && b == n->b ? -1 : rules[n->op].again(g, a, b);
}

void gather_coefficients(graph *g, node *roots, size_t count)
{
    const size_t before = g->count;
    tuned t = {.g = g};
    bool *needed = arena_take(g->memory, before, sizeof *needed);
    node *to = arena_take(g->memory, before, sizeof *to);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < before; i++) {
        const graph_node n = g->nodes[i];
        to[i] = (node)i;
        if (needed[i] && operators[n.op].operands > 0) {
            const size_t known = g->count;
            const node result = again(&t, &n, to[n.a], operators[n.op].operands == 2 ? to[n.b] : n.b);
            to[i] = result < 0 ? (node)i : result;
            if ((size_t)to[i] >= known && !is_constant(g, to[i])) {
                g->nodes[to[i]].name = n.name;
                g->nodes[to[i]].section = n.section;
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = to[roots[i]];
    }
}
