#include "tools/isoc/graph/operations.h"

#include "tools/isoc/graph/economy.h"

/* Sums of iso_take_turns in core/numbers/turns.h, and as many products. */
enum { OPERATIONS_OF_WRAP = 5 };

operations count_operations(const graph *of, const node *of_roots, size_t count)
{
    operations made = {0};
    node *roots = arena_take(of->memory, count + 1, sizeof *roots);
    const graph economical = economise(of, of_roots, count, roots), *g = &economical;
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    bool *turned = arena_take(g->memory, g->count, sizeof *turned);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        if (needed[i]) {
            const bool trigonometric = n->op == OP_SIN || n->op == OP_COS;
            made.add += (n->op >= OP_ADD && n->op < OP_DIV && n->op != OP_MUL) || n->op == OP_NEG || n->op == OP_ABS;
            made.mul += n->op == OP_MUL;
            made.add += n->op == OP_WRAP ? OPERATIONS_OF_WRAP : 0;
            made.mul += n->op == OP_WRAP ? OPERATIONS_OF_WRAP : 0;
            made.div += n->op == OP_DIV;
            made.sincos += trigonometric && !turned[n->a];
            turned[n->a] = turned[n->a] || trigonometric;
        }
    }
    return made;
}

int cycles_of(operations n)
{
    enum { DIVISION = 14 };
    return n.add + n.mul + DIVISION * n.div;
}

bool uses_operation(const graph *g, const node *roots, size_t count, operation op)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    bool used = false;
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        used = used || (needed[i] && g->nodes[i].op == op);
    }
    return used;
}
