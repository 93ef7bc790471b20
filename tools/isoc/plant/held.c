#include "tools/isoc/plant/held.h"

#include "tools/isoc/graph/differentiate.h"
#include "tools/isoc/graph/operations.h"

/* Whether each node follows from tunables and held inputs alone; constants do not count. A sign stays where it is used: it
 * costs nothing there. */
static void find_held(const graph *g, const mechanism *m, bool *is_held)
{
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        const int operands = operators[n->op].operands;
        const bool smooth = n->op == OP_INPUT && n->index < m->input_count && m->smooth[n->index];
        const bool a = operands > 0 && (is_held[n->a] || is_constant(g, n->a));
        const bool b = operands < 2 || is_held[n->b] || is_constant(g, n->b);
        is_held[i] = operands == 0 ? n->op == OP_PARAMETER || (n->op == OP_INPUT && !smooth)
                                   : n->op != OP_NEG && a && b && !is_constant(g, (node)i);
    }
}

/* Takes down a held node, unless it is an input, which is read from its own array. */
static void take(const graph *g, held *made, node *to, const bool *is_held, node n)
{
    if (is_held[n] && g->nodes[n].op != OP_INPUT && to[n] == n) {
        made->values[made->count] = n;
        to[n] = -1 - made->count++;
    }
}

/* The largest nodes that are held, below the roots: those that what is not held reads. */
static held list_held(const graph *g, const bool *is_held, const node *roots, size_t count, node *to)
{
    held made = {.values = arena_take(g->memory, g->count, sizeof *made.values)};
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        if (needed[i] && !is_held[i] && operators[n->op].operands > 0) {
            take(g, &made, to, is_held, n->a);
        }
        if (needed[i] && !is_held[i] && operators[n->op].operands == 2) {
            take(g, &made, to, is_held, n->b);
        }
    }
    for (size_t i = 0; i < count; i++) {
        take(g, &made, to, is_held, roots[i]);
    }
    return made;
}

static int tunables_read(const graph *g, const node *roots, size_t count)
{
    bool *needed = arena_take(g->memory, g->count, sizeof *needed);
    int found = 0;
    graph_reach(g, roots, count, needed);
    for (size_t i = 0; i < g->count; i++) {
        found += needed[i] && g->nodes[i].op == OP_PARAMETER;
    }
    return found;
}

/* Cycles of a step: each evaluation reads what is held, which is computed and written once. */
static bool pays(const graph *g, const held *made, const node *before, const node *after, size_t count, int evaluations)
{
    const int saved = cycles_of(count_operations(g, before, count)) - cycles_of(count_operations(g, after, count));
    const int computed = cycles_of(count_operations(g, made->values, (size_t)made->count));
    const int more_reads = made->count - tunables_read(g, before, count);
    return evaluations * (saved - more_reads) > computed + made->count + tunables_read(g, before, count);
}

held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations)
{
    const size_t before = g->count;
    bool *is_held = arena_take(g->memory, before, sizeof *is_held);
    node *to = arena_take(g->memory, before, sizeof *to), *after = arena_take(g->memory, count, sizeof *after);
    find_held(g, m, is_held);
    for (size_t i = 0; i < before; i++) {
        to[i] = (node)i;
    }
    held made = list_held(g, is_held, roots, count, to);
    for (int i = 0; i < made.count; i++) {
        to[made.values[i]] = leaf(g, OP_HELD, i);
    }
    for (size_t i = 0; i < count; i++) {
        after[i] = roots[i];
    }
    replace_nodes(g, after, count, before, to);
    if (!pays(g, &made, roots, after, count, evaluations)) {
        return (held){0};
    }
    for (size_t i = 0; i < count; i++) {
        roots[i] = after[i];
    }
    return made;
}
