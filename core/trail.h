/* What a method keeps from step to step behind the states, and what is done with it alike for every method: advancing
 * the state, keeping slopes, checking a step.
 *
 * All of it is known at compile time: a pointer that is NULL, or a count that is zero, leaves no code.
 */
#ifndef ISO_CORE_TRAIL_H
#define ISO_CORE_TRAIL_H

#include "core/plant.h"
#include "core/tableau.h"
#include "core/unroll.h"

typedef struct iso_trail {
    size_t n;
    real *x;          /* [n] the states */
    real *slopes;     /* [kept n] at the steps before this one, the newest first */
    real *increments; /* [ISO_BDF4_STEPS n] of the steps before this one, the newest first; only bdf4 */
    real *moved;      /* [n] the last increment; NULL where steps are not checked */
    real *carry;      /* [n] what rounding has taken from x so far; NULL where x is not compensated */
    uint8_t kept;
    uint8_t order; /* of the method, where steps are checked */
} iso_trail;

/* x[s] += dx. Compensated: the rounding error of the sum, exact by Knuth (1998), The Art of Computer Programming 2,
 * 4.2.2, theorem B, is carried to the next step (Kahan 1965; Moller 1965). No branch, and right under the flags that all
 * is compiled with, which forbid a compiler to take the difference for zero. */
static inline void iso_advance(const iso_trail *const trail, const size_t s, const real dx)
{
    if (trail->moved != NULL) {
        trail->moved[s] = dx;
    }
    if (trail->carry == NULL) {
        trail->x[s] += dx;
    } else {
        const real x = trail->x[s];
        const real add = dx + trail->carry[s];
        const real sum = x + add;
        const real added = sum - x;
        trail->carry[s] = (x - (sum - added)) + (add - added);
        trail->x[s] = sum;
    }
}

/* Puts the slope of this step before the kept ones. */
static inline void iso_keep_slope(const iso_trail *const trail, const real *const slope)
{
    const size_t n = trail->n;
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        ISO_UNROLL
        for (size_t j = trail->kept; j-- > 1;) {
            trail->slopes[j * n + s] = trail->slopes[(j - 1) * n + s];
        }
        if (trail->kept > 0) {
            trail->slopes[s] = slope[s];
        }
    }
}

/* The largest of |a| and |b|. */
static inline real iso_larger(const real a, const real b)
{
    return iso_max(iso_abs(a), iso_abs(b));
}

/* The local error of the last step, state by state, at no evaluation: its increment against that of the implicit Adams
 * method of one order more, whose slopes are all known now: `slope` at the end of that step, the kept ones before.
 * Exact to h^(order + 2). error[n], or NULL to give only the largest, which is returned. */
static inline real iso_check(const iso_trail *const trail, const real h, const real *const slope, real *const error)
{
    real largest = R(0.0);
    if (trail->moved != NULL) {
        const iso_adams *const am = &iso_table_am[trail->order];
        const real h_over = h / (real)am->over;
        ISO_UNROLL
        for (size_t s = 0; s < trail->n; s++) {
            real sum = (real)am->b[0] * slope[s];
            ISO_UNROLL
            for (size_t j = 0; j < trail->order; j++) {
                sum += (real)am->b[j + 1] * trail->slopes[j * trail->n + s];
            }
            const real e = trail->moved[s] - h_over * sum;
            largest = iso_larger(largest, e);
            if (error != NULL) {
                error[s] = e;
            }
        }
    }
    return largest;
}

#endif
