#include "tools/isoc/graph/graph.h"

#include <string.h>

static operations count_anew(const graph *original, const node *of_roots, size_t count)
{
    operations result = {0};
    node *roots = arena_take(original->memory, count + 1, sizeof *roots);
    graph economical = economise(original, of_roots, count, roots);
    const graph *g = &economical;
    bool *turned = arena_take(g->memory, g->count, sizeof *turned);
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        const operations cost = operators[r.n->op].cost;
        result.add += cost.add;
        result.mul += cost.mul;
        result.div += cost.div;
        result.sincos += cost.sincos > 0 && !turned[r.n->a];
        turned[r.n->a] = turned[r.n->a] || cost.sincos > 0;
    }
    arena_return(g->memory, turned, g->count, sizeof *turned);
    arena_return(original->memory, roots, count + 1, sizeof *roots);
    graph_free(&economical);
    return result;
}

operations count_operations(const graph *g, const node *roots, size_t count)
{
    if (g->counts == NULL || count == 0) {
        return count_anew(g, roots, count);
    }
    FOR_EACH (const counted_roots, known, *g->counts) {
        if (known->count == count && memcmp(known->roots, roots, count * sizeof *roots) == 0) {
            return known->found;
        }
    }
    const counted_roots one = {list_copy(g->memory, roots, count, sizeof *roots), count, count_anew(g, roots, count)};
    LIST_ADD(g->memory, *g->counts, one);
    return one.found;
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
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        if (operators[r.n->op].kind == kind && (op == OPERATIONS || r.n->op == op)) {
            reach_end(&r);
            return true;
        }
    }
    return false;
}

bool uses_operation(const graph *g, const node *roots, size_t count, operation op)
{
    return uses(g, roots, count, operators[op].kind, op);
}

bool uses_leaf(const graph *g, const node *roots, size_t count, node leaf)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        if (r.at == leaf) {
            reach_end(&r);
            return true;
        }
    }
    return false;
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
