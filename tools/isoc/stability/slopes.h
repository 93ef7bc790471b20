/* The Jacobian of the derivatives as numbers. */
#ifndef ISOC_STABILITY_SLOPES_H
#define ISOC_STABILITY_SLOPES_H

#include "tools/isoc/plant/plant.h"

/* The change of each of some nodes, as of the derivatives, with the changes of the states as inputs behind those of the plant. */
typedef struct linearised {
    const mechanism *m;
    graph g;
    node *changes;
} linearised;

linearised linearise(const graph *g, const mechanism *m, const node *roots, size_t count);

/* J[n n] row by row. A quaternion q counts as three: the rotation about the axes of its parent that moves it, dq = phi q / 2,
 * of which none lets a change of q itself grow; what changes its length is no part of the motion. */
typedef struct slopes {
    int n, positions; /* the first rows are of positions, the others of speeds */
    double *at;
    int infinite;  /* a state whose column is not finite, or -1 */
    bool *is_fast; /* [n] those that take sub-steps of their own, so many of them; 0 sub-steps: none does */
    int fast_count, substeps;
} slopes;

slopes slopes_at(const linearised *l, const double *x, const double *u);

#endif
