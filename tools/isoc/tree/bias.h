/* What the tree of links would take to move with q'' = 0: recursive Newton-Euler, as nodes.
 *
 * Luh, Walker, Paul (1980), "On-line computational scheme for mechanical manipulators", J. Dynamic Systems,
 * Measurement, and Control 102(2), about link origins after Khalil and Kleinfinger (1987).
 */
#ifndef ISOC_TREE_BIAS_H
#define ISOC_TREE_BIAS_H

#include "tools/isoc/tree/wrench.h"

/* What a link's joint adds to its acceleration by turning its own rate. */
acceleration joint_coriolis(const kinematics *k, int link);

/* The acceleration of a link at q'' = 0 from that of its parent, which stands in `all`. */
acceleration accelerate_outward(const kinematics *k, int link, const acceleration *all);

/* What each link takes by itself for its acceleration, less what forces on it give. */
void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches);

/* From the tips to the root: efforts[degrees of freedom] from what each link takes by itself; the wrenches
 * become those of all that hangs on a link. */
void efforts_of_wrenches(const kinematics *k, wrench *wrenches, node *efforts);

/* Fills bias[degrees of freedom] with the efforts, less what forces on bodies give, and accelerations[links].
 */
void bias_build(const kinematics *k, node *bias, acceleration *accelerations);

/* The acceleration of a point of a link, or of the ground, in its axes. */
vector point_acceleration(const kinematics *k, const acceleration *accelerations, int link, vector point);

#endif
