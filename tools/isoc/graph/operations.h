/* The operations of a set of nodes, and their cycles. */
#ifndef ISOC_GRAPH_OPERATIONS_H
#define ISOC_GRAPH_OPERATIONS_H

#include "tools/isoc/graph/graph.h"

/* The operations of the code of these roots. */
operations count_operations(const graph *g, const node *roots, size_t count);

/* a + times * b */
operations operations_plus(operations a, int times, operations b);

/* Cycles of a Cortex-M4F, but for sines and cosines, which every way to the same equations shares. */
int cycles_of(operations n);

/* Whether any node of this operation is needed for the roots. */
bool uses_operation(const graph *g, const node *roots, size_t count, operation op);

/* Whether this leaf is. */
bool uses_leaf(const graph *g, const node *roots, size_t count, node leaf);

/* Whether a node can change while the parameters stay. */
bool can_change(const graph *g, node n);

/* Whether any function of the tick is. */
bool uses_time(const graph *g, const node *roots, size_t count);

#endif
