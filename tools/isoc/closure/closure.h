/* Shared by the files of closures. */
#ifndef ISOC_CLOSURE_CLOSURE_H
#define ISOC_CLOSURE_CLOSURE_H

#include "tools/isoc/tree/tree.h"

/* constraints.c: the constraints of the loop closures, as nodes: of each constraint its position Phi(q),
 * its rate Phi', its row Phi_q of the Jacobian, and its bias, the value of Phi'' at q'' = 0.
 *
 * Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 7. Rows are made from the velocities of points
 * and axes, joint by joint, in axes of choice (below). A row without an entry is dropped: no
 * joint changes such a constraint, as out of the plane of a planar mechanism. */

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
    int closure;   /* the closure that it is part of; -1: of none */
    node position; /* m or rad; zero of a constraint of velocities only */
    node rate;
    node bias;
    node length;          /* of a distance; of a disc, the height of its centre */
    node *row;            /* [degrees of freedom] */
    vector force, moment; /* on the child, in base axes, about its point, of a multiplier of one; both zero of joints */
} constraint;

typedef struct constraints {
    constraint *all;
    int count;
    constraint *dropped; /* that no joint changes: their positions are constants, and zero if the scene can close */
    int dropped_count;
} constraints;

/* The largest |Phi|, or |Phi'| of all constraints. */
node largest_violation(const kinematics *k, const constraints *phi, bool of_rates);

constraints constraints_build(const kinematics *k, const acceleration *accelerations, closure_axes axes);

/* augmented.c: the equations of motion with closures, by the augmentation method, as nodes:
 *
 *     [ M      Phi_q' ] [ q''    ]   [ effort - bias ]
 *     [ Phi_q  0      ] [ lambda ] = [ gamma         ],   gamma = -Phi_dd - 2 alpha Phi' - beta^2 Phi
 *
 * solved by the Schur complement A = Phi_q M^-1 Phi_q' over the factors of M: A lambda = Phi_q M^-1 (effort - bias) -
 * gamma. Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 13; gamma after Baumgarte (1972),
 * "Stabilization of constraints and integrals of motion in dynamical systems", Comp. Meth. Appl. Mech. Eng. 1.
 *
 * The augmented Lagrangian of Bayo, Garcia de Jalon and Serna (1988), "A modified Lagrangian formulation for the
 * dynamic analysis of constrained mechanical systems", Comp. Meth. Appl. Mech. Eng. 71, is the same with A + 1/penalty
 * in the place of A, which has an inverse even where A has none, and a few iterations of the multipliers. In its
 * iteration lambda grows by delta with (A + e) delta = r, e = 1/penalty, and the new residual r is e delta: so that
 * each further iteration is one more solution with the same factors. Where the scene gives no penalty, e is the mean of
 * A's diagonal at the start times the square root of the unit roundoff u: rounding then changes A + e, and the
 * multipliers that no constraint needs, by a part of sqrt(u) at most, and a constraint is held wherever it moves the
 * degrees of freedom by more than u^(1/4) of its usual effect on them.
 *
 * Where A has the eigenvalue a, n iterations leave (e / (a + e))^n of the right-hand side, and make up to n / e of a
 * rounding error where a is near zero. This remainder is missing power: a linkage that passes near a singular position,
 * but not through it, has a small a there and a large demand, for it turns a sharp corner. With n = 6 less than 2 % is
 * left at a = e, and less than u at 15 e in float, with n = 3 12 % and at 255 e. More iterations gain little, since the
 * corner is shorter than a step by then, and disturb the motion more where the closures do lose rank. A parallelogram
 * (models/parallelogram.scene) in float with steps of 1 ms for 10 s, with 8 speeds of 1 to 6 rad/s: the energy changes
 * by a part of at most (isochron sweep --set 'speed = 1 .. 6 rad/s by 8' --of 'max energy; min energy')
 *
 *     follower longer by    0       1 mm    3 mm    10 mm
 *     n = 3                 2e-4    7e-2    3e-3    2e-4
 *     n = 6                 5e-4    9e-3    7e-4    2e-4
 *     n = 10                1e-3    9e-3    8e-4    2e-4
 *     n = 3, in double      4e-10   9e-3    8e-4    5e-5
 *
 * of which the last line is the error of the method itself. */

/* legs.c: degrees of freedom that are eliminated behind the constraints.
 *
 * Closures of legs share the degrees of freedom of their platform, so that A is full, though no leg meets another, and
 * its factors cost the third power of the number of constraints. With the shared ones s apart from the others l,
 *
 *     [ A_l   V    ] [ lambda ]   [ demand of the others  ]
 *     [ V'   -M_s  ] [ -q''_s ] = [ effort - bias of s    ],    A_l = Phi_l M_l^-1 Phi_l',
 *
 * A_l has a block for each leg, and its Schur complement has the size of the platform's freedom. A_l must have an
 * inverse: the constraints of each closure are independent by its leg alone. This is checked at the start.
 *
 * A stretched leg has none, though A = A_l + V M_s^-1 V' may have one. So the pivot of a leg is at least e, and where
 * legs have knees (turns about parallel axes), which stretch at an ordinary angle, the solution is refined once (static
 * pivoting: Li and Demmel 1998, "Making sparse Gaussian elimination scalable by static pivoting", Proc. SC98). Where a
 * is the platform's part of A's diagonal, e causes a relative error e / a of lambda, and rounding one of about u a / e,
 * with the unit roundoff u: so e = 4 sqrt(u) a, with the numbers at the start. In
 * tests/isoc/dynamics/formulation/stretched.scene 4 is the best of 1, 4, 16 and 64: the accelerations are off by 2
 * sqrt(u) in double and 10 sqrt(u) in float while a leg passes its stretched position; refined, by 30 u and 90 u, as
 * without legs. */

/* [degrees of freedom] those that closures share, with all their ancestors; NULL where legs cannot be eliminated. */
const bool *find_shared(const mass_matrix *mass, const constraints *phi);

/* Whether a leg has a knee; the mass matrix leaves the shared degrees of freedom. */
bool have_knees(const mass_matrix *mass);

typedef struct augmented {
    const mass_matrix *mass;
    constraints phi;  /* closed: Phi, its derivatives and its bias */
    int *shared;      /* [size - constraints] degrees of freedom that are eliminated behind the constraints: those that
                       * mass->is_left */
    int size;         /* constraints, and shared degrees of freedom */
    int *order;       /* [size] in which they are eliminated: the one with the fewest neighbours first */
    node **inward;    /* [constraints][degrees of freedom] L'^-1 Phi_q' */
    node **reach;     /* [constraints][degrees of freedom] D^-1 L'^-1 Phi_q' */
    node *schur;      /* [size size] A + e, beside it the shared columns, and -M: after the factorisation L, and 1 / D
                       * on the diagonal */
    node *unfactored; /* [size size] schur before the factorisation */
    node *pivots;     /* [size] D */
    node *diagonal;   /* [constraints] of A + e */
    node regularisation; /* e */
    node *multipliers;   /* [constraints] lambda */
} augmented;

/* legs.c: [constraints] e, with `part` in the place of sqrt(u), before the factorisation; zero where nothing is shared.
 * numbers[] are those of the nodes at the start. */
double *least_pivots(const augmented *a, const double *numbers, double part);

/* The factors of A + e alone: without multipliers. */
augmented augmented_factors(const mass_matrix *mass, constraints phi);

/* From effort := L'^-1 (effort - bias) to effort := D^-1 L'^-1 (effort - bias - Phi_q' lambda). */
augmented augmented_build(const mass_matrix *mass, constraints phi, node *effort);

/* -gamma of a constraint: Phi_dd + 2 alpha Phi' + beta^2 Phi, or Phi_dd + alpha Phi' of one of speeds alone: its root
 * is where the double root of the others is with alpha = beta. */
node demand_of(graph *g, const mechanism *m, const constraint *c);

/* From scaled = D^-1 L'^-1 efforts to the same with what the closures add to these efforts; multipliers[constraints]
 * are those of the addition. */
void augmented_respond(const augmented *a, node *scaled, node *multipliers);

/* [degrees of freedom] their change with the least kinetic energy that removes `gap` from the constraints: -M^-1 Phi_q'
 * (A + e)^-1 gap. */
node *augmented_project(const augmented *a, const node *gap);

/* The product of the inverses of all bounded pivots, relative to its value at the start. */
node augmented_inverse_determinant(const augmented *a);

#endif
