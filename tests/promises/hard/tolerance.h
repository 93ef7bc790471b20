/* Adams on the stiff cases: no step and no budget, but a tolerance, as on the host. Explicit, it resolves every decay
 * of the fastest mode, however little of that is left.
 *
 * What must hold follows from the test equation y' = -lambda y (Dahlquist 1963), on which the very method is run over
 * an octave of lambda: since its steps are powers of two, that is all there is. Stability bounds its steps, so y swings
 * about 0 for ever: up at one step, down at half of it, as the error passes the tolerance. Taken from there:
 *   how far y swings, in tolerances. So far a stiff solution is off: the fast mode forgets all local errors but the
 * last. What steps so short leave in the other modes is small, but adds up and does not follow the tolerance, which
 * therefore is chosen above it. the mean square of the swing, the largest of all lambda, which drives the other states
 * where the equations have squares. how many sub-steps a decay takes; in double, since in float rounding has a part in
 * it: zero derivatives, and noise.
 */
#ifndef ISO_TESTS_HARD_TOLERANCE_H
#define ISO_TESTS_HARD_TOLERANCE_H

#include "tests/promises/hard/hard.h"

/* A solution at a time. */
typedef struct hard_point {
    double t;
    const long double *exact;
} hard_point;

typedef struct hard_tolerance {
    double tolerance;
    double tick;
    double decays;   /* the integral of |lambda| of the fastest mode, up to the last point */
    double squared;  /* the largest factor of a square in the equations, if it counts */
    double rounding; /* epsilons */
} hard_tolerance;

/* One test of every point along one run: every state x is right to tolerance (1 + |x|) times the swing, and to what
 * squares and rounding add; in double one of the sub-steps up to the last point; and the control that with a hundred
 * tolerances not all points hold. */
void hard_expect_tolerance(const hard_problem *problem, const hard_point *points, size_t count,
                           const hard_tolerance *claim);

#endif
