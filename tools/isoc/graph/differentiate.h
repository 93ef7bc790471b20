/* Symbolic differentiation, and putting nodes in the place of leaves. */
#ifndef ISOC_GRAPH_DIFFERENTIATE_H
#define ISOC_GRAPH_DIFFERENTIATE_H

#include "tools/isoc/graph/graph.h"

/* The derivatives of `count` roots by a leaf. */
void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives);

/* Their change, to first order, where every state of the graph changes by along[state]. */
void differentiate_along(graph *g, const node *roots, size_t count, const node *along, node *changes);

/* Derivatives by some nodes as if they were leaves: what they are made of is not looked at. */
typedef struct partials {
    graph *g;
    size_t count;      /* of nodes: those made later are not differentiated */
    const bool *stops; /* [count] where to end */
    node *parts;       /* of the root, those that it is made of, in order; work space like the next two */
    node *d;           /* [count] */
    bool *seen;        /* [count] */
} partials;

partials partials_start(graph *g, const bool *stops);

/* The derivatives of one root by each stop that it depends on without another between: by[] and derivatives[], which the
 * memory of the graph has. Returns their number. The root may be a stop itself. */
size_t partial_derivatives(partials *p, node root, node **by, node **derivatives);

/* Puts by[index] in the place of every leaf of this operation, in `count` roots. */
void replace_leaves(graph *g, node *roots, size_t count, operation op, const node *by);

/* The root with another node in the place of one leaf. */
node replace_leaf(graph *g, node root, node leaf, node by);

/* Makes the roots anew of what stands in the place of each node that there was: to[before], itself where it stays. */
void replace_nodes(graph *g, node *roots, size_t count, size_t before, node *to);

#endif
