/* The states at the end of a step, from those that the method computed, as nodes: quaternions of length one, and with
 * projection, positions and speeds that satisfy the closures. */
#ifndef ISOC_DYNAMICS_SETTLED_H
#define ISOC_DYNAMICS_SETTLED_H

#include "tools/isoc/dynamics/dynamics.h"

typedef struct settled {
    int count;
    int *states; /* which */
    node *values;
} settled;

settled settled_build(graph *g, const dynamics *d);

#endif
