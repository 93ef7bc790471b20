/* Scalars of formulas, and their dimensions. */
#ifndef ISOC_FORMULA_SCALAR_H
#define ISOC_FORMULA_SCALAR_H

#include "tools/isoc/formula/value.h"

static const dimension plain = DIMENSION(0, 0, 0, 0, 0, 0), metre = DIMENSION(0, 1, 0, 0, 0, 0),
                       second = DIMENSION(0, 0, 1, 0, 0, 0), radian = DIMENSION(0, 0, 0, 1, 0, 0),
                       hertz = DIMENSION(0, 0, -1, 0, 0, 0), radian_per_second = DIMENSION(0, 0, -1, 1, 0, 0);
static const double pi = 3.14159265358979323846;
static const double most_ticks = 4e9; /* of 2^32 */

static inline value scalar(node n, dimension dim)
{
    return (value){.count = 1, .parts = {n}, .dim = dim};
}

/* impact.c: the law of impact of Hunt and Crossley, which stops, bumpers, backlash and contacts share. */

/* The restitutions that have a damping. Without any rest it would be infinite. */
#define LEAST_RESTITUTION 0.01

/* The damping d, for a speed of impact of 1, with which the force k x (1 + d x') at the depth x leaves the part e of
 * the speed, from LEAST_RESTITUTION to 1. Of constants within 1e-13; of tunables in float within 1e-5 of it. */
node impact_damping(graph *g, node e);

#endif
