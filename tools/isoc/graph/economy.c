#include "tools/isoc/graph/graph.h"

#include <float.h>
#include <math.h>
#include <string.h>

typedef struct economy {
    const graph *from;
    graph to;
    node *moved; /* where a node is in `to` */
    int *uses;
    node *multiple; /* a product of a constant and this node, or -1; and the next one of the same node */
    node *next;
    node *term[2]; /* a c (x y) that this node is a factor of, as x or as y; and the next one with the same */
    node *after[2];
} economy;

/* Whether a node is an operation that serves one other alone. */
static bool serves_one(const economy *e, node i, operation op)
{
    return e->from->nodes[i].op == op && e->uses[i] == 1;
}

/* Whether a node is c (x y) with a constant c, the only use of x y. */
static bool is_scaled_product(const economy *e, const graph_node *n)
{
    return n->op == OP_MUL && is_constant(e->from, n->a) && serves_one(e, n->b, OP_MUL) &&
           !is_constant(e->from, e->from->nodes[n->b].a);
}

/* The constant multiples of each node, and the scaled products that it is a factor of. */
static void list_multiples(economy *e)
{
    const size_t size = e->from->count * sizeof *e->multiple;
    memset(e->multiple, -1, size);
    memset(e->term[0], -1, size);
    memset(e->term[1], -1, size);
    for (size_t i = 0; i < e->from->count; i++) {
        const graph_node *n = &e->from->nodes[i];
        if (is_scaled_product(e, n)) {
            const graph_node product = e->from->nodes[n->b];
            for (int k = 0; k < (product.a == product.b ? 1 : 2); k++) {
                const node x = k == 0 ? product.a : product.b;
                e->after[k][i] = e->term[k][x];
                e->term[k][x] = (node)i;
            }
        } else if (n->op == OP_MUL && is_constant(e->from, n->a)) {
            e->next[i] = e->multiple[n->b];
            e->multiple[n->b] = (node)i;
        }
    }
}

/* x (1 / p) is x / p. */
static bool divide_once(economy *e, graph_node *n)
{
    for (int swap = 0; swap < 2; swap++) {
        const node x = swap ? n->b : n->a, inverse = swap ? n->a : n->b;
        const graph_node at = e->from->nodes[inverse];
        if (serves_one(e, inverse, OP_DIV) && is_value(e->from, at.a, 1.0)) {
            n->op = OP_DIV;
            n->a = e->moved[x];
            n->b = e->moved[at.b];
            return true;
        }
    }
    return false;
}

/* a x + b x is (a + b) x. */
static bool factor_out(economy *e, graph_node *n)
{
    const graph_node left = e->from->nodes[n->a], right = e->from->nodes[n->b];
    if (!serves_one(e, n->a, OP_MUL) || !serves_one(e, n->b, OP_MUL)) {
        return false;
    }
    const node of_left[2] = {left.a, left.b}, of_right[2] = {right.a, right.b};
    for (int i = 0; i < 4; i++) {
        if (of_left[i / 2] == of_right[i % 2]) {
            const graph_node sum = {.op = n->op,
                                    .a = e->moved[of_left[1 - i / 2]],
                                    .b = e->moved[of_right[1 - i % 2]],
                                    .section = n->section};
            n->op = OP_MUL;
            n->b = graph_put(&e->to, sum);
            n->a = e->moved[of_left[i / 2]];
            return true;
        }
    }
    return false;
}

/* Constants that differ only by rounding are the same. */
static bool is_same(double a, double b)
{
    return fabs(a - b) <= 4 * DBL_EPSILON * fabs(b);
}

/* A term of a sum as a constant times the rest: c x, or (c x) y, where no other node uses the operands. */
typedef struct scaled {
    double constant; /* 0: there is none */
    node x, y;       /* y is -1 where there is none */
} scaled;

static scaled scaled_of(const economy *e, node term)
{
    const graph_node n = e->from->nodes[term];
    if (!serves_one(e, term, OP_MUL)) {
        return (scaled){0};
    }
    if (is_constant(e->from, n.a)) {
        return (scaled){constant_value(e->from, n.a), n.b, -1};
    }
    for (int swap = 0; swap < 2; swap++) {
        const node root = swap ? n.b : n.a, other = swap ? n.a : n.b;
        const graph_node inner = e->from->nodes[root];
        if (serves_one(e, root, OP_MUL) && is_constant(e->from, inner.a)) {
            return (scaled){constant_value(e->from, inner.a), inner.b, other};
        }
    }
    return (scaled){0};
}

static node put_product(economy *e, node a, node b, int section)
{
    const bool in_order = is_constant(&e->to, a) || (a < b && !is_constant(&e->to, b));
    return graph_put(&e->to,
                     (graph_node){.op = OP_MUL, .a = in_order ? a : b, .b = in_order ? b : a, .section = section});
}

static node put_rest(economy *e, scaled term, int section)
{
    return term.y < 0 ? e->moved[term.x] : put_product(e, e->moved[term.x], e->moved[term.y], section);
}

/* c x + (c y) z is c (x + y z). */
static bool factor_constant_out(economy *e, graph_node *n)
{
    const scaled left = scaled_of(e, n->a), right = scaled_of(e, n->b);
    if (left.constant == 0.0 || !is_same(left.constant, right.constant)) {
        return false;
    }
    graph_node sum = {.op = n->op, .section = n->section};
    sum.a = put_rest(e, left, n->section);
    sum.b = put_rest(e, right, n->section);
    n->b = graph_put(&e->to, sum);
    n->op = OP_MUL;
    n->a = constant(&e->to, left.constant);
    return true;
}

/* The multiple of x by c that is there, or x itself for c = 1, or -1. */
static node known_multiple(const economy *e, node x, double c)
{
    node found = is_same(c, 1.0) ? x : -1;
    for (node m = e->multiple[x]; m >= 0 && found < 0; m = e->next[m]) {
        found = is_same(c, constant_value(e->from, e->from->nodes[m].a)) ? m : -1;
    }
    return found;
}

/* The number of scaled products by c that the node is a factor of. */
static int terms_of(const economy *e, node x, double c)
{
    int count = 0;
    for (int k = 0; k < 2; k++) {
        for (node t = e->term[k][x]; t >= 0; t = e->after[k][t]) {
            count += is_same(c, constant_value(e->from, e->from->nodes[t].a));
        }
    }
    return count;
}

static void move(economy *e, node i);

/* The node x itself, or a multiple of it that may stand further down, as may its constant: x is there already. */
static node move_multiple(economy *e, node root)
{
    const graph_node n = e->from->nodes[root];
    if (n.op == OP_MUL && is_constant(e->from, n.a)) {
        move(e, n.a);
    }
    move(e, root);
    return e->moved[root];
}

/* c (x y) is (a x) (b y) with a b = c, where a x and b y are there: one product in place of two. */
static bool share_multiples(economy *e, graph_node *n)
{
    if (!is_scaled_product(e, n)) {
        return false;
    }
    const double c = constant_value(e->from, n->a);
    const graph_node at = e->from->nodes[n->b];
    node left = at.a, right = known_multiple(e, at.b, c);
    for (node m = e->multiple[at.a]; m >= 0 && right < 0; m = e->next[m]) {
        left = m;
        right = known_multiple(e, at.b, c / constant_value(e->from, e->from->nodes[m].a));
    }
    if (right < 0) {
        return false;
    }
    const node a = move_multiple(e, left), b = move_multiple(e, right);
    n->a = a < b ? a : b;
    n->b = a < b ? b : a;
    return true;
}

/* c (x y) and c (x z) are (c x) y and (c x) z: three products in place of four. */
static bool share_scaled_factor(economy *e, graph_node *n)
{
    if (!is_scaled_product(e, n)) {
        return false;
    }
    const graph_node at = e->from->nodes[n->b];
    const double c = constant_value(e->from, n->a);
    for (int swap = 0; swap < 2; swap++) {
        const node x = swap ? at.b : at.a, y = swap ? at.a : at.b;
        if (terms_of(e, x, c) > 1) {
            const node multiple = put_product(e, constant(&e->to, c), e->moved[x], n->section);
            const node other = e->moved[y];
            n->a = multiple < other ? multiple : other;
            n->b = multiple < other ? other : multiple;
            return true;
        }
    }
    return false;
}

/* Whether a node has a simpler form, as far as other uses of its operands allow it; n is then that form. */
static bool simplify(economy *e, graph_node *n)
{
    switch (n->op) {
    case OP_ADD:
    case OP_SUB:
        return factor_out(e, n) || factor_constant_out(e, n);
    case OP_MUL:
        return share_multiples(e, n) || share_scaled_factor(e, n) || divide_once(e, n);
    default:
        return false;
    }
}

static void move(economy *e, node i)
{
    graph_node n = e->from->nodes[i];
    const int operands = operators[n.op].operands;
    if (!simplify(e, &n)) {
        n.a = operands > 0 ? e->moved[n.a] : n.a;
        n.b = operands == 2 ? e->moved[n.b] : n.b;
    }
    e->moved[i] = graph_put(&e->to, n);
}

graph economise(const graph *g, const node *roots, size_t count, node *result)
{
    enum { LISTS = 7 };
    graph part = graph_part(g, roots, count, result);
    const size_t n = part.count;
    node *lists = arena_take(g->memory, LISTS * n, sizeof *lists);
    economy e = {.from = &part, .moved = lists, .multiple = lists + n, .next = lists + 2 * n};
    for (int k = 0; k < 2; k++) {
        e.term[k] = lists + (3 + (size_t)k) * n;
        e.after[k] = lists + (5 + (size_t)k) * n;
    }
    graph_start_like(&e.to, &part);
    e.uses = arena_take(g->memory, n, sizeof *e.uses);
    graph_uses(&part, result, count, NULL, e.uses);
    list_multiples(&e);
    for (size_t i = 0; i < n; i++) {
        move(&e, (node)i);
    }
    for (size_t i = 0; i < count; i++) {
        result[i] = e.moved[result[i]];
    }
    arena_return(g->memory, lists, LISTS * n, sizeof *lists);
    arena_return(g->memory, e.uses, n, sizeof *e.uses);
    graph_free(&part);
    graph result_graph = negate_free(&e.to, result, count);
    graph_free(&e.to);
    return result_graph;
}
