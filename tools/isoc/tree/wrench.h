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

/* bias.c: the efforts that the tree of segments needs to move with q'' = 0: recursive Newton-Euler, as nodes.
 *
 * Luh, Walker, Paul (1980), "On-line computational scheme for mechanical manipulators", J. Dynamic Systems,
 * Measurement, and Control 102(2), about segment origins after Khalil and Kleinfinger (1987).
 */

/* The acceleration of a segment that comes from turning its joint's own rate. */
acceleration joint_coriolis(const kinematics *k, int segment);

/* The acceleration of a segment at q'' = 0 from that of its parent, which stands in `all`. */
acceleration accelerate_outward(const kinematics *k, int segment, const acceleration *all);

/* The wrench that each segment alone needs for its acceleration, less the forces on it. */
void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches);

/* From the tips to the root: efforts[degrees of freedom] from the wrenches of single segments, which become those of
 * segments with their descendants. */
void efforts_of_wrenches(const kinematics *k, wrench *wrenches, node *efforts);

/* Fills bias[degrees of freedom] with the efforts, less those of forces on bodies, and accelerations[segments]. */
void bias_build(const kinematics *k, node *bias, acceleration *accelerations);

#endif
