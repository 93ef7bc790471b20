/* Springs and dampers between points, as nodes. With r from the first end to the second, d = |r| and d' = r . r' / d, the
 * tension is T = k (d - length) + c d'; a degree of freedom feels -T / d times g = r . dr/dq.
 *
 * 1 / d is finite for r = 0 (core/numbers/root.h), and r and g are zero there: a spring whose ends meet exerts no force,
 * and no number overflows on the way.
 */
#ifndef ISOC_DYNAMICS_SPRINGS_H
#define ISOC_DYNAMICS_SPRINGS_H

#include "tools/isoc/closure/side.h"

typedef struct stretched {
    vector apart;                   /* r, in base axes */
    node square, inverse, distance; /* d^2, 1 / d, d */
    node rate;                      /* d' */
    node *row;                      /* [degrees of freedom] g */
    node by_length;                 /* T / d */
} stretched;

/* All springs of the mechanism. */
stretched *springs_build(const kinematics *k);

/* The force on the second end, in base axes; the first has the opposite. */
vector spring_force(graph *g, const stretched *s);

/* T, larger than zero where it pulls. */
node spring_tension(graph *g, const point_spring *p, const stretched *s);

/* Its potential energy. */
node spring_energy(graph *g, const point_spring *p, const stretched *s);

#endif
