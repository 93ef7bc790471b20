#include "tools/isoc/graph/economy.h"

#include <string.h>

typedef struct economy {
    const graph *from;
    graph to;
    node *moved; /* where a node is in `to` */
    bool *needed;
    int *uses;
} economy;

static void count_uses(economy *e, const node *roots, size_t count)
{
    graph_reach(e->from, roots, count, e->needed);
    for (size_t i = 0; i < e->from->count; i++) {
        const graph_node *n = &e->from->nodes[i];
        if (e->needed[i]) {
            e->uses[n->a] += operators[n->op].operands > 0;
            e->uses[n->b] += operators[n->op].operands == 2;
        }
    }
    for (size_t i = 0; i < count; i++) {
        e->uses[roots[i]]++;
    }
}

/* Whether a node is an operation that serves one other alone. */
static bool serves_one(const economy *e, node i, operation op)
{
    return e->from->nodes[i].op == op && e->uses[i] == 1;
}

/* x (1 / p) is x / p. */
static bool divide_once(economy *e, graph_node *n)
{
    for (int swap = 0; swap < 2; swap++) {
        const node x = swap ? n->b : n->a, inverse = swap ? n->a : n->b;
        const graph_node of = e->from->nodes[inverse];
        if (serves_one(e, inverse, OP_DIV) && is_constant(e->from, of.a) && constant_value(e->from, of.a) == 1.0) {
            n->op = OP_DIV;
            n->a = e->moved[x];
            n->b = e->moved[of.b];
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

static void move(economy *e, node i)
{
    graph_node n = e->from->nodes[i];
    const bool is_sum = n.op == OP_ADD || n.op == OP_SUB, is_product = n.op == OP_MUL;
    const int operands = operators[n.op].operands;
    if (!(is_sum && factor_out(e, &n)) && !(is_product && divide_once(e, &n))) {
        n.a = operands > 0 ? e->moved[n.a] : n.a;
        n.b = operands == 2 ? e->moved[n.b] : n.b;
    }
    e->moved[i] = graph_put(&e->to, n);
}

graph economise(const graph *g, const node *roots, size_t count, node *made)
{
    economy e = {.from = g};
    graph_start_like(&e.to, g);
    e.moved = arena_take(g->memory, g->count, sizeof *e.moved);
    e.needed = arena_take(g->memory, g->count, sizeof *e.needed);
    e.uses = arena_take(g->memory, g->count, sizeof *e.uses);
    count_uses(&e, roots, count);
    for (size_t i = 0; i < g->count; i++) {
        if (e.needed[i]) {
            move(&e, (node)i);
        }
    }
    for (size_t i = 0; i < count; i++) {
        made[i] = e.moved[roots[i]];
    }
    arena_return(g->memory, e.moved, g->count, sizeof *e.moved);
    arena_return(g->memory, e.needed, g->count, sizeof *e.needed);
    arena_return(g->memory, e.uses, g->count, sizeof *e.uses);
    return e.to;
}
