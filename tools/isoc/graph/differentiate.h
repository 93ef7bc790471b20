/* Symbolic differentiation, and putting nodes in the place of leaves. */
#ifndef ISOC_GRAPH_DIFFERENTIATE_H
#define ISOC_GRAPH_DIFFERENTIATE_H

#include "tools/isoc/graph/graph.h"

/* The derivatives of `count` roots by a leaf. */
void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives);

/* Puts by[index] in the place of every leaf of this operation, in `count` roots. */
void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by);

/* The root with another node in the place of one leaf. */
node replace_leaf(graph *g, node root, node leaf, node by);

#endif
