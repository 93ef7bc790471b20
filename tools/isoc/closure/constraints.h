/* The constraints of the loop closures, as nodes: of each constraint its position Phi(q),
 * its rate Phi', its row Phi_q of the Jacobian, and its bias, what Phi'' is at q'' = 0.
 *
 * Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 7. Rows are made from the velocities of points
 * and axes, joint by joint, in axes of choice (tools/isoc/closure/side.h). A row without an entry is dropped: no joint
 * changes such a constraint, as out of the plane of a planar mechanism.
 */
#ifndef ISOC_CLOSURE_CONSTRAINTS_H
#define ISOC_CLOSURE_CONSTRAINTS_H

#include "tools/isoc/closure/side.h"

typedef struct constraint {
    int closure;   /* the closure that it is part of */
    node position; /* m or rad; zero of a constraint of velocities only */
    node rate;
    node bias;
    node length;          /* of a distance; of a disc, the height of its centre */
    node *row;            /* [degrees of freedom] */
    vector force, moment; /* on the child, in base axes, about its point, of a multiplier of one; both zero of joints */
} constraint;

typedef struct constraints {
    constraint *all;
    int count, room;
    int dropped;        /* constraints that no joint changes */
    node *dropped_gaps; /* their gaps: constants, and zero if the scene can close */
    int *dropped_closures;
} constraints;

/* The largest |Phi|, or |Phi'| of all constraints. */
node largest_violation(const kinematics *k, const constraints *held, bool of_rates);

constraints constraints_build(const kinematics *k, const acceleration *accelerations, closure_axes axes);

#endif
