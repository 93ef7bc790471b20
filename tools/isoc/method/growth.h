/* Where methods are stable: x' = lambda x, z = h lambda, by the step that the kernel itself makes (step_map.h).
 *
 * Growth per step is the largest modulus of an eigenvalue of that step: |R(z)| of a one-step method, of a multistep
 * method the largest root of its characteristic polynomial. Hairer and Wanner (1996), Solving Ordinary Differential
 * Equations II, IV.2, IV.7 and V.1.
 */
#ifndef ISOC_METHOD_GROWTH_H
#define ISOC_METHOD_GROWTH_H

#include "tools/isoc/base/arena.h"

/* The growth per step of a recipe at z = re + i im: of a speed v' = re v, or of the oscillation q' = |z| v, v' = 2 re v
 * - |z| q, whose eigenvalues are z and its conjugate. Infinite where the step is not finite. An option of the recipe
 * makes no difference but for the iterations. */
double growth_of(arena *memory, unsigned recipe, double re, double im);

/* The largest modulus of an eigenvalue of a step [n n]; infinite where it is not finite. */
double growth_of_map(arena *memory, const double *map, int n);

/* The fastest motions that a method holds with a step. */

typedef struct stability_limits {
    double rate;      /* h |lambda| of a decay without oscillation */
    double frequency; /* h omega of an oscillation with a tenth of critical damping */
} stability_limits;

/* The limits of a recipe: where it first has growth, to four decimals. An implicit method damps the motions in its
 * Jacobian at the start of a step, but not those that begin within the step: for these a rate counts to 4 at most,
 * which leaves 2 % of the motion, and a frequency to 2, a third of a turn. adams has the limits of a sub-step; its
 * sub-steps follow the error. */
stability_limits limits_of(unsigned recipe);

#endif
