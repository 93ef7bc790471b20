/* The one expression graph. A node is an operation on earlier nodes; equal nodes are the same node; constants fold and
 * zeros, ones, negations and repeated terms vanish as a node is made. Algorithms are written over nodes as they would
 * be over numbers. The simplifications are those of exact arithmetic: they happen before the bits are fixed.
 *
 * Nodes are numbered as they are made, and the operands of sums and products stand in that order. C leaves open which
 * argument of a call, operand or initialiser is evaluated first: so at most one of them makes nodes other than
 * constants, and the others are made before, one after the other. Then every compiler's isoc writes the same bytes.
 */
#ifndef ISOC_GRAPH_GRAPH_H
#define ISOC_GRAPH_GRAPH_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/isoc/base/arena.h"
#include "tools/isoc/graph/operators.h"

typedef struct graph_node {
    operation op;
    node a, b;
    int index;
    double value, second;
    int section;      /* the heading under which it was made */
    const char *name; /* of the quantity in its equation, or NULL */
} graph_node;

typedef struct graph {
    arena *memory;
    graph_node *nodes;
    size_t count, room;
    node *table; /* open addressing, -1 is free */
    size_t table_size;
    const char **sections;
    int section_count;
    size_t section_room;
} graph;

void graph_start(graph *g, arena *memory);

/* An empty graph with the headings of another. */
void graph_start_like(graph *g, const graph *other);

/* A graph to try on: what is made in it is not in the other. */
graph graph_copy(const graph *g);

/* Gives back what holds the nodes. */
void graph_free(graph *g);

/* Nodes made from here on stand under this heading. */
void graph_section(graph *g, const char *heading);

/* Gives a node its name in the generated code, unless it is a constant or has one. Returns the node. */
node graph_name(graph *g, node n, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* A node as it is, under its own heading, without simplification. */
node graph_put(graph *g, graph_node n);

node constant(graph *g, double value);
node leaf(graph *g, operation op, int index);
node timed(graph *g, operation op, double value, double second); /* of a function of the tick */
node timed_by_index(graph *g, operation op, double value, double second, int index);

node add(graph *g, node a, node b);
node sub(graph *g, node a, node b);
node mul(graph *g, node a, node b);
node divide(graph *g, node a, node b);
node neg(graph *g, node a);
node larger(graph *g, node a, node b);
node above(graph *g, node a, node b);
node magnitude(graph *g, node a);
node wrap(graph *g, node a);
node sine(graph *g, node a);
node cosine(graph *g, node a);
node power(graph *g, node a, int n); /* n >= 0 */

/* One of ISOC_FUNCTIONS; where it has one operand, b counts for nothing. */
node function(graph *g, operation op, node a, node b);

/* a b + c d, and a b - c d. */
node sum_of_products(graph *g, node a, node b, node c, node d);
node difference_of_products(graph *g, node a, node b, node c, node d);

bool is_constant(const graph *g, node n);
bool is_timed(const graph *g, node n);
bool is_zero(const graph *g, node n);
double constant_value(const graph *g, node n);

/* The numbers of the nodes from `first` on (values[g->count]), from those before them; functions of time, dx, and x or u
 * that are NULL, count as zero. */
void graph_evaluate(const graph *g, size_t first, const evaluation *at, double *values);

/* Marks needed[g->count] for all that the `count` roots depend on. */
void graph_reach(const graph *g, const node *roots, size_t count, bool *needed);

#endif
