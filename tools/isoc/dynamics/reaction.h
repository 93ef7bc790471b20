/* What joints and closures give to their children, as nodes: force and moment in the ground's axes, the moment about
 * the origin of the joint's frame on the child.
 *
 * Of a joint it is all that passes through it: what it constrains, and what drive, damping and spring, gear and motion
 * put on it. It is what the child takes to move as it does, less what else acts on it: recursive Newton-Euler with the
 * accelerations that the mechanism has, over bodies, since the parameters of links are regrouped. Of a closure it is
 * the multipliers times what each constraint bears; what holds by the shape of the scene bears nothing.
 */
#ifndef ISOC_DYNAMICS_REACTION_H
#define ISOC_DYNAMICS_REACTION_H

#include "tools/isoc/dynamics/dynamics.h"

/* Accelerations of the links, of the accelerations that `derivative` gives; for joint_reaction. */
acceleration *reaction_accelerations(const dynamics *d);

/* Of the joint whose child is body `of`. */
wrench joint_reaction(const dynamics *d, const acceleration *accelerations, int of);

wrench closure_reaction(const dynamics *d, int index);

/* Of a gear or a motion: what it puts on its first joint, in N*m or N; on the second, a gear puts -ratio times that.
 * Its one constraint has the factor 1 in the first joint's row of M q'' + Phi_q' lambda = effort. */
node closure_effort(const dynamics *d, int index);

#endif
