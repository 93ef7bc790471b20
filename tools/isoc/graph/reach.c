/* The nodes that a set of nodes depends on. */
#include "tools/isoc/graph/graph.h"

#include <string.h>

/* The number of nodes up to the last root. */
static size_t end_of(const node *roots, size_t count)
{
    size_t end = 0;
    for (size_t i = 0; i < count; i++) {
        end = (size_t)roots[i] >= end ? (size_t)roots[i] + 1 : end;
    }
    return end;
}

/* Marks the roots, and all that they depend on, in needed[end_of(roots, count)], which is false before. */
static void mark(const graph *g, const node *roots, size_t count, bool *needed)
{
    for (size_t i = 0; i < count; i++) {
        needed[roots[i]] = true;
    }
    for (size_t i = end_of(roots, count); i-- > 0;) {
        const graph_node *n = &g->nodes[i];
        if (needed[i] && operators[n->op].operands > 0) {
            needed[n->a] = true;
            needed[n->b] = needed[n->b] || operators[n->op].operands == 2;
        }
    }
}

void graph_reach(const graph *g, const node *roots, size_t count, bool *needed)
{
    memset(needed, 0, g->count * sizeof *needed);
    mark(g, roots, count, needed);
}

void graph_uses(const graph *g, const node *roots, size_t count, const bool *needed, int *uses)
{
    for (size_t i = 0; i < g->count; i++) {
        const graph_node *n = &g->nodes[i];
        if (needed == NULL || needed[i]) {
            uses[n->a] += operators[n->op].operands > 0;
            uses[n->b] += operators[n->op].operands == 2;
        }
    }
    for (size_t i = 0; i < count; i++) {
        uses[roots[i]]++;
    }
}

reached reach(const graph *g, const node *roots, size_t count)
{
    reached r = {.g = g, .count = end_of(roots, count), .at = -1};
    r.needed = arena_take(g->memory, r.count, 1);
    mark(g, roots, count, r.needed);
    return r;
}

void reach_end(reached *r)
{
    arena_return(r->g->memory, r->needed, r->count, 1);
}

bool reach_next(reached *r)
{
    do {
        r->at++;
    } while ((size_t)r->at < r->count && !r->needed[r->at]);
    const bool more = (size_t)r->at < r->count;
    r->n = more ? &r->g->nodes[r->at] : NULL;
    if (!more) {
        reach_end(r);
    }
    return more;
}

void mark_leaves(const graph *g, const node *roots, size_t count, operation op, bool *marked)
{
    for (reached r = reach(g, roots, count); reach_next(&r);) {
        if (r.n->op == op) {
            marked[r.n->index] = true;
        }
    }
}
