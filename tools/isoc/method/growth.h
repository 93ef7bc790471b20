/* Where methods are stable: x' = lambda x, z = h lambda, by the step that the kernel itself makes.
 *
 * Growth per step is the largest modulus of an eigenvalue of that step: |R(z)| of a one-step method, of a multistep
 * method the largest root of its characteristic polynomial. Hairer and Wanner (1996), Solving Ordinary Differential
 * Equations II, IV.2, IV.7 and V.1.
 */
#ifndef ISOC_METHOD_GROWTH_H
#define ISOC_METHOD_GROWTH_H

#include <stdbool.h>

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

/* step_map.c: the map of a step of a method on x' = J x: a matrix, since every kernel is linear there. It is that of
 * the kernel itself, which tools have in double: a step from each unit vector. */

typedef struct linear_plant {
    const double *jacobian; /* [n n] row by row */
    int n, positions;       /* the first rows are of positions, the others of speeds */
} linear_plant;

/* The map of the states and the recipe's history over a step: [*size *size] row by row, the states first. For adams it
 * is one sub-step, at its highest order. */
double *step_map(arena *memory, unsigned recipe, const linear_plant *l, double step, int *size);

/* b of the 1 - h b J that a step of the kernel solves with; 0 where it solves nothing. */
double implicit_part(arena *memory, unsigned recipe);

/* The map of a step of two rates (core/methods/multirate.h) with the fast ones of the states: [n n]; for the methods
 * that it has. */
double *two_rates_map(arena *memory, unsigned recipe, const linear_plant *l, const bool *is_fast, int substeps,
                      double step);

#endif
