/* The equations of motion before they are solved, as nodes: the forces less those that given accelerations q'' and
 * multipliers lambda need,
 *
 *     left = effort - bias - M q'' - Phi_q' lambda    and    -(Phi_dd + Phi_q q'' + 2 alpha Phi' + beta^2 Phi),
 *
 * which is zero in the motion. Its derivatives are far fewer operations than those of the solution.
 */
#ifndef ISOC_DYNAMICS_BALANCE_H
#define ISOC_DYNAMICS_BALANCE_H

#include "tools/isoc/dynamics/dynamics.h"

/* Degrees of freedom and constraints. */
int balance_rows(const dynamics *d);

typedef struct balance {
    int rows;
    node *left;                        /* [rows] by leaves OP_DERIVATIVE of the accelerations and OP_MULTIPLIER */
    node *weights;                     /* [rows rows] what it has of them: [M Phi_q'; Phi_q -1/penalty] */
    const acceleration *accelerations; /* [segments] what Newton-Euler hands on from segment to segment, outward */
    wrench *wrenches;                  /* [segments] and inward: of a segment with its descendants */
} balance;

balance balance_build(const dynamics *d);

#endif
