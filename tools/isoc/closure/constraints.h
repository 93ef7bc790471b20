/* The constraints of the loop closures, as nodes: of each constraint its position Phi(q),
 * its rate Phi', its row Phi_q of the Jacobian, and its bias, the value of Phi'' at q'' = 0.
 *
 * Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 7. Rows are made from the velocities of points
 * and axes, joint by joint, in axes of choice (tools/isoc/closure/constraints.h). A row without an entry is dropped: no
 * joint changes such a constraint, as out of the plane of a planar mechanism.
 */
#ifndef ISOC_CLOSURE_CONSTRAINTS_H
#define ISOC_CLOSURE_CONSTRAINTS_H

#include "tools/isoc/tree/wrench.h"

/* side.c: how the two sides of a loop closure move, as nodes, in the axes of one segment of the loop.
 *
 * The choice of axes changes the cost of the equations, not the motion. Vectors that are fixed in that segment are
 * constant there; so where a platform is closed by six legs, or a rod by one pin, most entries of the Jacobian are
 * constants in its axes.
 */

/* The segment in whose axes a closure is written: the last common ancestor of both sides, or the last segment of a
 * side. */
typedef enum closure_axes { AXES_OF_BASE, AXES_OF_PARENT, AXES_OF_CHILD } closure_axes;

typedef struct side {
    vector point, velocity, acceleration; /* from the base's origin, and its rates at q'' = 0 */
    vector omega, alpha;
    vector *linear, *angular; /* [degrees of freedom] the part of each in the velocity and in the angular velocity */
    matrix axes;              /* columns: of the closure's frame */
} side;

/* turns[segment + 1]: from the axes of each segment of the loop, and of its base, to those chosen. */
const matrix *loop_turns(const kinematics *k, const closure *c, closure_axes chosen);

side side_build(const kinematics *k, const acceleration *all, const closure_end *end, int base, const matrix *turns);

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
node largest_violation(const kinematics *k, const constraints *phi, bool of_rates);

constraints constraints_build(const kinematics *k, const acceleration *accelerations, closure_axes axes);

#endif
