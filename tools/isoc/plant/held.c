#include "tools/isoc/plant/plant.h"

#include <string.h>

/* The nodes of a growing graph that follow from tunables and constants alone. */
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

/* A node as a factor of tunables alone, times the rest. */
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

static node product_of(tuned *t, node a, node b)
{
    graph *g = t->g;
    if (is_tuned(t, a) && is_tuned(t, b)) {
        return mul(g, a, b);
    }
    const product pa = is_tuned(t, a) ? (product){a, constant(g, 1.0)} : split(t, a);
    const product pb = is_tuned(t, b) ? (product){b, constant(g, 1.0)} : split(t, b);
    if (is_value(g, pa.tuned, 1.0) || is_value(g, pb.tuned, 1.0)) {
        return mul(g, a, b);
    }
    const node of_both = mul(g, pa.tuned, pb.tuned), rest = mul(g, pa.rest, pb.rest);
    return mul(g, of_both, rest);
}

static node again(graph *g, const graph_node *n, node a, node b, void *context)
{
    tuned *t = context;
    if (n->op == OP_MUL) {
        return product_of(t, a, b);
    }
    if (n->op == OP_DIV && is_tuned(t, b) && !is_tuned(t, a)) {
        return product_of(t, divide(g, constant(g, 1.0), b), a);
    }
    return node_again(g, n, a, b, NULL);
}

/* In all nodes below the roots, c (p x) becomes (c p) x, (p x) (q y) becomes (p q) (x y), and x / p becomes (1 / p) x,
 * for p and q of tunables: a product of factors of tunables alone is then one number, which is computed when a tunable
 * changes. */
static void gather_coefficients(graph *g, node *roots, size_t count)
{
    tuned t = {.g = g};
    replace_nodes_by(g, roots, count, g->count, all_nodes(g), again, &t);
}

/* Whether each node follows from constant leaves alone: from tunables, or from held values and inputs.
 * Constants do not count. A sign stays where it is used: it costs nothing there. */
static void find_held(const graph *g, const mechanism *m, bool of_inputs, bool *is_held)
{
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        const int operands = operators[n->op].operands;
        const bool smooth = n->op == OP_INPUT && n->index < m->inputs.sampled_count && m->inputs.smooth[n->index];
        const bool a = operands > 0 && (is_held[n->a] || is_constant(g, n->a));
        const bool b = operands < 2 || is_held[n->b] || is_constant(g, n->b);
        const bool leaf = of_inputs ? n->op == OP_HELD || (n->op == OP_INPUT && !smooth) : n->op == OP_PARAMETER;
        is_held[i] = operands == 0 ? leaf : n->op != OP_NEG && a && b && !is_constant(g, (node)i);
    }
}

/* Lists a held node, unless it is read from an array of its own. */
static void take(const graph *g, held *result, node *to, const bool *is_held, node n)
{
    const operation op = g->nodes[n].op;
    if (is_held[n] && op != OP_INPUT && op != OP_HELD && to[n] == n) {
        result->values[result->count] = n;
        to[n] = -1 - result->count++;
    }
}

/* The largest held nodes below the roots: those that a node which is not held reads. */
static void list_held(const graph *g, const bool *is_held, const node *roots, size_t count, held *result, node *to)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        const node read[] = {r.n->a, r.n->b};
        for (int i = 0; i < operators[r.n->op].operands && !is_held[r.at]; i++) {
            take(g, result, to, is_held, read[i]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        take(g, result, to, is_held, roots[i]);
    }
}

/* The roots with leaves OP_HELD for further held nodes, which are added to `result`. */
static held hold_more(graph *g, const mechanism *m, bool of_inputs, held result, node *roots, size_t count)
{
    const size_t before = g->count;
    bool *is_held = arena_take(g->memory, before, sizeof *is_held);
    node *to = all_nodes(g), *list = arena_take(g->memory, before + (size_t)result.count, sizeof *list);
    const int first = result.count;
    for (int i = 0; i < first; i++) {
        list[i] = result.values[i];
    }
    result.values = list;
    find_held(g, m, of_inputs, is_held);
    list_held(g, is_held, roots, count, &result, to);
    for (int i = first; i < result.count; i++) {
        to[result.values[i]] = leaf(g, OP_HELD, i);
    }
    replace_nodes(g, roots, count, before, to);
    return result;
}

static int tunables_read(const graph *g, const node *roots, size_t count)
{
    int found = 0;
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        found += r.n->op == OP_PARAMETER;
    }
    return found;
}

/* Cycles that a step saves by reading so many values more in each evaluation. */
static int saved_by(const graph *g, const node *before, const node *after, size_t count, int reads, int evaluations)
{
    const int saved = cycles_of(count_operations(g, before, count)) - cycles_of(count_operations(g, after, count));
    return evaluations * (saved - reads);
}

held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations)
{
    enum { LOOK = 16, LOOK_EACH = 2 }; /* whether a tunable has changed: cycles of a tick */
    const int tunables = tunables_read(g, roots, count);
    node *changed = list_copy(g->memory, roots, count, sizeof *roots);
    held result = {0};
    int saved = 0;
    if (tunables > 0) {
        gather_coefficients(g, changed, count);
        result = hold_more(g, m, false, result, changed, count);
        result.tuned = result.count;
        saved = saved_by(g, roots, changed, count, result.tuned - tunables, evaluations) - LOOK - LOOK_EACH * tunables;
    }
    node *once = list_copy(g->memory, changed, count, sizeof *changed);
    const held all = hold_more(g, m, true, result, once, count);
    const int more = all.count - all.tuned;
    const int computed = cycles_of(count_operations(g, all.values + all.tuned, (size_t)more));
    const int saved_once = saved_by(g, changed, once, count, more, evaluations) - computed - more;
    if (saved_once > 0) {
        saved += saved_once;
        result = all;
        changed = once;
    }
    if (saved <= 0) {
        return (held){0};
    }
    memcpy(roots, changed, count * sizeof *roots);
    return result;
}
