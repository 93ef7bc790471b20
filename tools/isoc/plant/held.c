#include "tools/isoc/plant/plant.h"

/* Whether each node follows from what does not change alone: from tunables, or from what is held of them and inputs.
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

/* Takes down a held node, unless it is read from an array of its own. */
static void take(const graph *g, held *result, node *to, const bool *is_held, node n)
{
    const operation op = g->nodes[n].op;
    if (is_held[n] && op != OP_INPUT && op != OP_HELD && to[n] == n) {
        result->values[result->count] = n;
        to[n] = -1 - result->count++;
    }
}

/* The largest nodes that are held, below the roots: those that what is not held reads. */
static void list_held(const graph *g, const bool *is_held, const node *roots, size_t count, held *result, node *to)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        if (!is_held[r.at] && operators[r.n->op].operands > 0) {
            take(g, result, to, is_held, r.n->a);
        }
        if (!is_held[r.at] && operators[r.n->op].operands == 2) {
            take(g, result, to, is_held, r.n->b);
        }
    }
    for (size_t i = 0; i < count; i++) {
        take(g, result, to, is_held, roots[i]);
    }
}

/* The roots with leaves OP_HELD for what is held besides `made`, which has it then. */
static held hold_more(graph *g, const mechanism *m, bool of_inputs, held result, node *roots, size_t count)
{
    const size_t before = g->count;
    bool *is_held = arena_take(g->memory, before, sizeof *is_held);
    node *to = arena_take(g->memory, before, sizeof *to),
         *list = arena_take(g->memory, before + (size_t)result.count, sizeof *list);
    for (int i = 0; i < result.count; i++) {
        list[i] = result.values[i];
    }
    for (size_t i = 0; i < before; i++) {
        to[i] = (node)i;
    }
    const int first = result.count;
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

static node *copy_of(const graph *g, const node *roots, size_t count)
{
    node *copy = arena_take(g->memory, count, sizeof *copy);
    for (size_t i = 0; i < count; i++) {
        copy[i] = roots[i];
    }
    return copy;
}

held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations)
{
    enum { LOOK = 16, LOOK_EACH = 2 }; /* whether a tunable has changed: cycles of a tick */
    const int tunables = tunables_read(g, roots, count);
    node *tuned = copy_of(g, roots, count);
    held result = {0};
    int saved = 0;
    if (tunables > 0) {
        gather_coefficients(g, tuned, count);
        result = hold_more(g, m, false, result, tuned, count);
        result.tuned = result.count;
        saved = saved_by(g, roots, tuned, count, result.tuned - tunables, evaluations) - LOOK - LOOK_EACH * tunables;
    }
    node *once = copy_of(g, tuned, count);
    const held all = hold_more(g, m, true, result, once, count);
    const int more = all.count - all.tuned;
    const int computed = cycles_of(count_operations(g, all.values + all.tuned, (size_t)more));
    const int saved_once = saved_by(g, tuned, once, count, more, evaluations) - computed - more;
    if (saved_once > 0) {
        saved += saved_once;
        result = all;
        tuned = once;
    }
    if (saved <= 0) {
        return (held){0};
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = tuned[i];
    }
    return result;
}
