/* The states at the end of a step, from those that the method computed, as nodes: quaternions of length one, and with
 * projection, positions and speeds that satisfy the closures. Where sums are compensated, the changes of the states, so that
 * these are added with the compensation too: a sum that is rounded without it, once a step, would undo what it gains. With
 * projection, the pivots too that it divides by. */
#ifndef ISOC_DYNAMICS_SETTLED_H
#define ISOC_DYNAMICS_SETTLED_H

#include "tools/isoc/dynamics/dynamics.h"

typedef struct settled {
    int count;
    int *states; /* which */
    node *values;
    bool adds;           /* the values are added to the states */
    node *pivots;        /* of the closures, those that vary: what a step is watched by (core/methods/pivots.h) */
    int *pivot_closures; /* whose */
    int pivot_count;
} settled;

settled settled_build(graph *g, const dynamics *d);

#endif
