/* How the two sides of a loop closure move, as nodes, in the axes of one segment of the loop.
 *
 * The choice of axes changes the cost of the equations, not the motion. What is fixed in that segment is constant
 * there; so where a platform is closed by six legs, or a rod by one pin, most entries of the Jacobian are constants in
 * its axes.
 */
#ifndef ISOC_CLOSURE_SIDE_H
#define ISOC_CLOSURE_SIDE_H

#include "tools/isoc/tree/bias.h"

/* The segment in whose axes a closure is written: the last common ancestor of both sides, or the last segment of a side. */
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

#endif
