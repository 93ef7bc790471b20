/* Negations that cost nothing: of a difference, or of a product with a constant. */
#include "tools/isoc/graph/graph.h"

#include <string.h>

typedef struct negation {
    const graph *from;
    graph to;
    node *moved; /* where a node is in `to` */
    int *uses;
} negation;

/* A part of a product or a sum whose negative is free, or -1. */
static node free_part(const negation *e, const graph_node *n);

/* Whether the negative of a node takes as many operations as the node itself, which serves one other alone. */
static bool is_free(const negation *e, node i)
{
    const graph_node *n = &e->from->nodes[i];
    return is_constant(e->from, i) || (e->uses[i] == 1 && (n->op == OP_SUB || free_part(e, n) >= 0));
}

static node free_part(const negation *e, const graph_node *n)
{
    if (n->op != OP_MUL && n->op != OP_ADD && n->op != OP_DIV) {
        return -1;
    }
    return is_free(e, n->a) ? n->a : is_free(e, n->b) ? n->b : -1;
}

/* The negative of the node minus_x has the name x, and the reverse. */
static const char *negative_name(const negation *e, const char *name)
{
    static const char minus[] = "minus_";
    const size_t length = sizeof minus - 1;
    if (name == NULL) {
        return NULL;
    }
    return strncmp(name, minus, length) == 0 ? name + length : arena_format(e->from->memory, "%s%s", minus, name);
}

/* The negative of a node for which is_free holds: -(a - b) is b - a, -(a b) is (-a) b, -(a + b) is (-a) - b. */
static node negative(negation *e, node i)
{
    if (is_constant(e->from, i)) {
        return constant(&e->to, -constant_value(e->from, i));
    }
    graph_node n = e->from->nodes[i];
    const node part = free_part(e, &n), a = n.a, b = n.b;
    n.name = negative_name(e, n.name);
    if (n.op == OP_SUB) {
        n.a = e->moved[b];
        n.b = e->moved[a];
    } else if (n.op == OP_ADD) {
        n.op = OP_SUB;
        n.a = negative(e, part);
        n.b = e->moved[part == a ? b : a];
    } else {
        n.a = part == a ? negative(e, a) : e->moved[a];
        n.b = part == a ? e->moved[b] : negative(e, b);
    }
    return graph_put(&e->to, n);
}

static void carry(negation *e, node i)
{
    graph_node n = e->from->nodes[i];
    if (n.op == OP_NEG && is_free(e, n.a)) {
        e->moved[i] = negative(e, n.a);
        return;
    }
    n.a = operators[n.op].operands > 0 ? e->moved[n.a] : n.a;
    n.b = operators[n.op].operands == 2 ? e->moved[n.b] : n.b;
    e->moved[i] = graph_put(&e->to, n);
}

graph negate_free(const graph *g, node *roots, size_t count)
{
    graph part = graph_part(g, roots, count, roots);
    negation e = {.from = &part};
    e.uses = arena_take(g->memory, part.count, sizeof *e.uses);
    e.moved = arena_take(g->memory, part.count, sizeof *e.moved);
    graph_start_like(&e.to, &part);
    graph_uses(&part, roots, count, NULL, e.uses);
    for (size_t i = 0; i < part.count; i++) {
        carry(&e, (node)i);
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = e.moved[roots[i]];
    }
    arena_return(g->memory, e.uses, part.count, sizeof *e.uses);
    arena_return(g->memory, e.moved, part.count, sizeof *e.moved);
    graph_free(&part);
    return e.to;
}
