/* What a step leaves the states at, from where the method leaves them, as nodes: quaternions of length one, and
 * positions and speeds that satisfy the closures, where the scene has them projected. */
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
