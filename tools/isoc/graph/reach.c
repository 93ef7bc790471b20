/* The nodes that a set of nodes depends on. */
#include "tools/isoc/graph/graph.h"

#include <stdlib.h>
#include <string.h>

void graph_reach(const graph *g, const node *roots, size_t count, bool *needed)
{
    memset(needed, 0, g->count * sizeof *needed);
    for (size_t i = 0; i < count; i++) {
        needed[roots[i]] = true;
    }
    for (size_t i = g->count; i-- > 0;) {
        const graph_node *n = &g->nodes[i];
        if (needed[i] && operators[n->op].operands > 0) {
            needed[n->a] = true;
            needed[n->b] = needed[n->b] || operators[n->op].operands == 2;
        }
    }
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

static int in_order(const void *a, const void *b)
{
    const node first = *(const node *)a, second = *(const node *)b;
    return (first > second) - (first < second);
}

void sort_nodes(node *nodes, size_t count)
{
    if (count > 1) {
        qsort(nodes, count, sizeof *nodes, in_order);
    }
}

/* Adds a node to those of this search, unless it is one of them. */
static void reach_node(reached *r, node n, uint32_t search)
{
    if (r->g->nodes[n].search != search) {
        r->g->nodes[n].search = search;
        ADD_TO(r->g->memory, r->all, r->count, r->room, n);
    }
}

/* The time is that of the nodes that are reached, not of all. */
reached reach(const graph *g, const node *roots, size_t count)
{
    static uint32_t searches = 0; /* of all graphs: a copy has the marks of the original */
    const uint32_t search = ++searches;
    reached r = {.g = g};
    for (size_t i = 0; i < count; i++) {
        reach_node(&r, roots[i], search);
    }
    for (size_t i = 0; i < r.count; i++) {
        const graph_node *n = &g->nodes[r.all[i]];
        const node below[] = {n->a, n->b};
        for (int k = 0; k < operators[n->op].operands; k++) {
            reach_node(&r, below[k], search);
        }
    }
    sort_nodes(r.all, r.count);
    return r;
}

void reach_end(reached *r)
{
    arena_return(r->g->memory, r->all, r->room, sizeof *r->all);
}

bool reach_next(reached *r)
{
    const bool more = r->next < r->count;
    if (more) {
        r->at = r->all[r->next++];
        r->n = &r->g->nodes[r->at];
    } else {
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
