/* Simplifications of a whole function: which simplifications pay depends on who else uses a node. */
#ifndef ISOC_GRAPH_ECONOMY_H
#define ISOC_GRAPH_ECONOMY_H

#include "tools/isoc/graph/graph.h"

/* The nodes that `count` roots need, in the same order, in a graph of their own, with fewer operations; made[count] are
 * the roots there. */
graph economise(const graph *g, const node *roots, size_t count, node *result);

#endif
