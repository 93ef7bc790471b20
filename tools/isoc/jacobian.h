/* What an implicit method solves with: 1 - hb J for the Jacobian J of x' = f(x), by symbolic differentiation, factored
 * without a pivot search and unrolled for its zeros. */
#ifndef ISOC_JACOBIAN_H
#define ISOC_JACOBIAN_H

#include "tools/isoc/graph.h"

typedef struct jacobian {
    node *factors; /* what factor() leaves in lu[] for solve() */
    int factor_count;
    node *solution; /* d[], from the right side and the factors */
} jacobian;

/* The derivatives of `count` roots by a leaf. */
void differentiate(graph *g, const node *roots, size_t count, node by, node *derivatives);

jacobian jacobian_build(graph *g, const node *slopes, int states);

#endif
