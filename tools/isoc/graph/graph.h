/* The one expression graph. A node is an operation on earlier nodes; equal nodes are the same node; constants fold and
 * zeros, ones, negations and repeated terms vanish as a node is made. Algorithms are written over nodes as they would
 * be over numbers. The simplifications are those of exact arithmetic: they happen before the bits are fixed.
 *
 * Nodes are numbered as they are made, and the operands of sums and products stand in that order. C leaves open which
 * argument of a call, operand or initialiser is evaluated first: so at most one of them makes nodes other than
 * constants, and the others are made before, one after the other (tests/check/test_arguments.py). Then every
 * compiler's isoc writes the same bytes.
 */
#ifndef ISOC_GRAPH_GRAPH_H
#define ISOC_GRAPH_GRAPH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tools/isoc/base/arena.h"
#include "tools/isoc/graph/operators.h"

typedef struct graph_node {
    operation op;
    node a, b;
    int index;
    double value, second;
    int section;      /* the heading under which it was made */
    uint32_t search;  /* the last that came to it (reach.c) */
    const char *name; /* of the quantity in its equation, or NULL */
} graph_node;

/* Of a table with open addressing. */
typedef struct graph_slot {
    uint32_t hash;
    node place; /* one more than a node, 0 is free */
} graph_slot;

/* The number of operations of these roots: a node never changes. */
typedef struct counted_roots {
    const node *roots;
    size_t count;
    operations found;
} counted_roots;

typedef LIST_OF(counted_roots) counted_roots_list;

/* The table of a function of the tick: the bits of a sequence, the coefficients of a sweep, or straight lines. */
typedef struct tick_table {
    uint32_t *words; /* bits; or the ticks at which the lines begin */
    double *values, *slopes;
    size_t count;
    double first, last; /* of a sweep, in turns: in its first tick, in a tick after it */
    double curve, ticks;
} tick_table;

typedef LIST_OF(tick_table) tick_table_list;

typedef struct graph {
    arena *memory;
    graph_node *nodes;
    size_t count, room;
    graph_slot *slots;
    size_t slot_count;
    counted_roots_list *counts; /* NULL where nothing is kept */
    tick_table_list *tables;    /* of functions of the tick, which know theirs by its index; copies have the same */
    const char **sections;
    int section_count;
    size_t section_room;
} graph;

/* Its first nodes stand under this heading. */
void graph_start(graph *g, arena *memory, const char *heading);

/* An empty graph with the headings of another, and room for as many nodes. */
void graph_start_like(graph *g, const graph *other);

/* A copy for trials: new nodes of the copy are not in the original. */
graph graph_copy(const graph *g);

/* Frees the memory of the nodes. */
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

/* One of ISOC_FUNCTIONS, a comparison, or any of one operand, where b counts for nothing. */
node function(graph *g, operation op, node a, node b);

/* a b + c d, and a b - c d. */
node sum_of_products(graph *g, node a, node b, node c, node d);
node difference_of_products(graph *g, node a, node b, node c, node d);

bool is_constant(const graph *g, node n);
bool is_timed(const graph *g, node n);
bool is_value(const graph *g, node n, double value);
bool is_zero(const graph *g, node n);
double constant_value(const graph *g, node n);

/* Whether a = slope b + offset with these constants, by form. */
bool is_line_in(graph *g, node a, node b, double *slope, double *offset);

/* The numbers of the nodes from `first` on (values[g->count]), from those before them; dx, and x or u that are NULL,
 * count as zero. */
void graph_evaluate(const graph *g, size_t first, const evaluation *at, double *values);

/* The nodes that the roots depend on, in their order, as a graph to read; in_part[count] are its roots, and may be the
 * same array. */
graph graph_part(const graph *g, const node *roots, size_t count, node *in_part);

/* Lists of so many zeros, and of all nodes. */
node *zero_nodes(graph *g, size_t count);
node *all_nodes(const graph *g);

/* reach.c: the nodes that a set of nodes depends on. */

/* Marks needed[g->count] for all that the `count` roots depend on. */
void graph_reach(const graph *g, const node *roots, size_t count, bool *needed);

/* The number of roots and needed nodes that use each node: uses[g->count], which is zero before. Without `needed`,
 * NULL, all are. */
void graph_uses(const graph *g, const node *roots, size_t count, const bool *needed, int *uses);

/* These nodes one by one, in their order: for (reached r = reach(g, roots, count); reach_next(&r);) has in r.n the
 * node r.at. Nodes that the loop itself makes are not among them. */
typedef struct reached {
    const graph *g;
    node *all;
    size_t count, room, next;
    node at;
    const graph_node *n;
} reached;

reached reach(const graph *g, const node *roots, size_t count);
bool reach_next(reached *r);

/* Puts them into their order. */
void sort_nodes(node *nodes, size_t count);

/* Before such a loop is left early. */
void reach_end(reached *r);

/* Marks marked[index] for the leaves of this operation among them. */
void mark_leaves(const graph *g, const node *roots, size_t count, operation op, bool *marked);

/* operations.c: the operations of a set of nodes, and their cycles. */

/* The operations of the code of these roots. */
operations count_operations(const graph *g, const node *roots, size_t count);

/* a + times * b */
operations operations_plus(operations a, int times, operations b);

/* Cycles of a Cortex-M4F, but for sines and cosines, which every way to the same equations shares. */
int cycles_of(operations n);

/* Whether any node of this operation is needed for the roots. */
bool uses_operation(const graph *g, const node *roots, size_t count, operation op);

/* Whether this leaf is needed for the roots. */
bool uses_leaf(const graph *g, const node *roots, size_t count, node leaf);

/* Whether a node can change while the parameters stay. */
bool can_change(const graph *g, node n);

/* Whether any function of the tick is needed for the roots. */
bool uses_time(const graph *g, const node *roots, size_t count);

/* economy.c: simplifications of a whole function: which simplifications pay depends on who else uses a node. The nodes
 * that `count` roots need, in the same order, in a graph of their own, with fewer operations; made[count] are the roots
 * there. */
graph economise(const graph *g, const node *roots, size_t count, node *result);

/* negation.c: a new graph without the negations that their operands can take in; the roots become nodes of it. */
graph negate_free(const graph *g, node *roots, size_t count);

/* differentiate.c: symbolic differentiation, and putting nodes in the place of leaves. */

/* The derivatives of `count` roots by a leaf. */
void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives);

/* Their change, to first order, where every state of the graph changes by along[state], and every input by
 * inputs[input]; NULL: these stay. */
void differentiate_along(graph *g, const node *roots, size_t count, const node *along, const node *inputs,
                         node *changes);

/* Derivatives by some nodes as if these were leaves: their operands are not visited. */
typedef struct partials {
    graph *g;
    size_t count;      /* of nodes: those made later are not differentiated */
    const bool *stops; /* [count] where to end */
    node *parts;       /* the nodes below the root, in order; work space like the next two */
    node *d;           /* [count] */
    bool *is_visited;  /* [count] */
} partials;

partials partials_start(graph *g, const bool *stops);

/* The derivatives of one root by each stop that it depends on without another between: by[] and derivatives[], which
 * the memory of the graph has. Returns their number. The root may be a stop itself. */
size_t partial_derivatives(partials *p, node root, node **by, node **derivatives);

/* Puts by[index] in the place of every leaf of this operation, in `count` roots. For several calls with the same
 * leaves: to[count] has what stands in the place of the nodes so far. */
typedef struct replacement {
    operation op;
    const node *by;
    node *to;
    size_t count, room;
} replacement;

void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by);
void replace_more_leaves(graph *g, node *roots, size_t count, replacement *r);

/* The root with another node in the place of one leaf. */
node replace_leaf(graph *g, node root, node leaf, node by);

/* Builds the roots again with to[before] in place of each old node; to[n] is n where a node stays. */
void replace_nodes(graph *g, node *roots, size_t count, size_t before, node *to);

/* The same, where `again` makes the node of other operands, or returns -1: it stays. */
typedef node node_maker(graph *g, const graph_node *n, node a, node b, void *context);
void replace_nodes_by(graph *g, node *roots, size_t count, size_t before, node *to, node_maker *again, void *context);
node node_again(graph *g, const graph_node *n, node a, node b, void *context); /* as it is */

#endif
