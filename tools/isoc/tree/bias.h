/* The efforts that the tree of segments needs to move with q'' = 0: recursive Newton-Euler, as nodes.
 *
 * Luh, Walker, Paul (1980), "On-line computational scheme for mechanical manipulators", J. Dynamic Systems,
 * Measurement, and Control 102(2), about segment origins after Khalil and Kleinfinger (1987).
 */
#ifndef ISOC_TREE_BIAS_H
#define ISOC_TREE_BIAS_H

#include "tools/isoc/tree/wrench.h"

/* The acceleration of a segment that comes from turning its joint's own rate. */
acceleration joint_coriolis(const kinematics *k, int segment);

/* The acceleration of a segment at q'' = 0 from that of its parent, which stands in `all`. */
acceleration accelerate_outward(const kinematics *k, int segment, const acceleration *all);

/* The wrench that each segment alone needs for its acceleration, less the forces on it. */
void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches);

/* From the tips to the root: efforts[degrees of freedom] from the wrenches of single segments, which become those of segments
 * with their descendants. */
void efforts_of_wrenches(const kinematics *k, wrench *wrenches, node *efforts);

/* Fills bias[degrees of freedom] with the efforts, less those of forces on bodies, and accelerations[segments]. */
void bias_build(const kinematics *k, node *bias, acceleration *accelerations);

#endif
