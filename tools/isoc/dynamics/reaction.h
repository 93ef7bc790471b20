/* Reactions of joints and closures on their children, as nodes: force and moment in the ground's axes, the moment about
 * the origin of the joint's frame on the child.
 *
 * Of a joint it is all that passes through it: what it constrains, and what drive, damping and spring, gear and motion
 * put on it. It is the wrench that the child needs for its motion, less all others on it: recursive Newton-Euler with
 * the accelerations that the mechanism has, over bodies, since the parameters of segments are regrouped. Of a closure it
 * is the sum of the wrenches of its constraints; a constraint that no joint changes has none.
 */
#ifndef ISOC_DYNAMICS_REACTION_H
#define ISOC_DYNAMICS_REACTION_H

#include "tools/isoc/dynamics/dynamics.h"

/* Accelerations of the segments, from those that `derivative` returns; for joint_reaction. */
acceleration *reaction_accelerations(const dynamics *d);

/* Of the joint whose child is body `of`. */
wrench joint_reaction(const dynamics *d, const acceleration *accelerations, int index);

wrench closure_reaction(const dynamics *d, int index);

/* The effort of a gear or a motion on its first joint, in N*m or N; a gear has -ratio times that on the second. Its one
 * constraint has the factor 1 in the first joint's row of M q'' + Phi_q' lambda = effort. */
node closure_effort(const dynamics *d, int index);

#endif
