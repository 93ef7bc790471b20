/* Forces with their moments, as nodes: in the axes of a segment or of the ground, about its origin. */
#ifndef ISOC_TREE_WRENCH_H
#define ISOC_TREE_WRENCH_H

#include "tools/isoc/tree/kinematics.h"

typedef struct wrench {
    vector force, moment;
} wrench;

/* Of a segment, the ground accelerated by -gravity; in segment axes. */
typedef struct acceleration {
    vector alpha; /* angular */
    vector a;     /* of the origin */
} acceleration;

wrench wrench_add(graph *g, wrench a, wrench b);
wrench wrench_sub(graph *g, wrench a, wrench b);

/* A force at a point, with a moment beside it. */
wrench wrench_at(graph *g, vector point, vector force, vector moment);

/* The wrench that a body needs for this motion. */
wrench wrench_of_motion(graph *g, composite whole, vector omega, acceleration now);

/* The wrench of a force on its segment. */
wrench wrench_of_applied_force(graph *g, const applied_force *t);

/* From a segment to its parent. */
wrench wrench_to_parent(const kinematics *k, int segment, wrench w);

#endif
