#include "tools/isoc/graph/graph.h"

operations count_operations(const graph *of, const node *of_roots, size_t count)
{
    operations result = {0};
    node *roots = arena_take(of->memory, count + 1, sizeof *roots);
    graph economical = economise(of, of_roots, count, roots);
    const graph *g = &economical;
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    bool *turned = arena_take(g->memory, g->count, sizeof *turned);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        const operations cost = operators[n->op].cost;
        if (needed[i]) {
            result.add += cost.add;
            result.mul += cost.mul;
            result.div += cost.div;
            result.sincos += cost.sincos > 0 && !turned[n->a];
            turned[n->a] = turned[n->a] || cost.sincos > 0;
        }
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
    arena_return(g->memory, turned, g->count, sizeof *turned);
    arena_return(of->memory, roots, count + 1, sizeof *roots);
    graph_free(&economical);
    return result;
}

operations operations_plus(operations a, int times, operations b)
{
    return (operations){a.add + times * b.add, a.mul + times * b.mul, a.div + times * b.div,
                        a.sincos + times * b.sincos};
}

int cycles_of(operations n)
{
    enum { DIVISION = 14 };
    return n.add + n.mul + DIVISION * n.div;
}

/* Whether any node that the roots need is of this kind, and of this operation unless that is OPERATIONS. */
static bool uses(const graph *g, const node *roots, size_t count, operator_kind kind, operation op)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    bool used = false;
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count && !used; i++) {
        const operation is = g->nodes[i].op;
        used = needed[i] && operators[is].kind == kind && (op == OPERATIONS || is == op);
    }
    arena_return(g->memory, needed, g->count, sizeof *needed);
    return used;
}

bool uses_operation(const graph *g, const node *roots, size_t count, operation op)
{
    return uses(g, roots, count, operators[op].kind, op);
}

bool uses_leaf(const graph *g, const node *roots, size_t count, node leaf)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, roots, count, needed);
    const bool used = needed[leaf];
    arena_return(g->memory, needed, g->count, sizeof *needed);
    return used;
}

bool uses_time(const graph *g, const node *roots, size_t count)
{
    return uses(g, roots, count, KIND_TIMED, OPERATIONS);
}

bool can_change(const graph *g, node n)
{
    return uses_operation(g, &n, 1, OP_STATE) || uses_operation(g, &n, 1, OP_INPUT) ||
           uses_operation(g, &n, 1, OP_QUERY) || uses_operation(g, &n, 1, OP_DERIVATIVE);
}
