/* Adams methods of order four with a fixed step, on slopes kept from the steps before. */
#ifndef ISO_CORE_MULTISTEP_H
#define ISO_CORE_MULTISTEP_H

#include "core/explicit.h"

/* h / over * (b[0] slope + b[1] kept[0] + ...), over `terms` slopes. */
static inline real iso_adams_increment(const iso_adams *const table, const real h, const real slope,
                                       const real *const kept, const size_t n, const uint8_t terms)
{
    real sum = (real)table->b[0] * slope;
    ISO_UNROLL
    for (uint8_t j = 1; j < terms; j++) {
        sum += (real)table->b[j] * kept[(j - 1) * n];
    }
    return h / (real)table->over * sum;
}

/* Adams-Bashforth, one evaluation: x += h / 24 (55 f - 59 f[-1] + 37 f[-2] - 9 f[-3]). Local error 251/720 h^5 x^(5).
 * work[n]. Returns the local error of the step before, where steps are checked. */
static inline real iso_ab4_step(const iso_trail *const trail, iso_derivative *const f, const real h,
                                const real *restrict const u, const real *restrict const p, real *restrict const work)
{
    f(work, trail->x, u, p);
    const real error = iso_check(trail, h, work, NULL);
    ISO_UNROLL
    for (size_t s = 0; s < trail->n; s++) {
        iso_advance(trail, s,
                    iso_adams_increment(&iso_table_ab4, h, work[s], trail->slopes + s, trail->n, ISO_AB4_STEPS));
    }
    iso_keep_slope(trail, work);
    return error;
}

/* Adams-Bashforth-Moulton: predict, then evaluate and correct `corrections` times, then evaluate once more if
 * `evaluate_last`: P(EC)^m or P(EC)^m E. The kept slopes begin with that of the state now, from the step before.
 * Local error -19/720 h^5 x^(5). work[2 n]. Returns Milne's estimate of it, of this very step: 19/270 of the largest
 * difference between predictor and corrector. */
static inline real iso_abm4_step(const iso_trail *const trail, iso_derivative *const f, const real h,
                                 const real *restrict const u, const real *restrict const p, real *restrict const work,
                                 const uint8_t corrections, const bool evaluate_last)
{
    const size_t n = trail->n;
    const real *const kept = trail->slopes;
    real *const slope = work;
    real *const at = work + n;
    real error = R(0.0);

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        at[s] = trail->x[s] + iso_adams_increment(&iso_table_ab4, h, kept[s], kept + n + s, n, ISO_AB4_STEPS);
    }
    ISO_UNROLL
    for (uint8_t i = 1; i < corrections; i++) {
        f(slope, at, u, p);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = trail->x[s] + iso_adams_increment(&iso_table_am[3], h, slope[s], kept + s, n, ISO_AB4_STEPS);
        }
    }
    f(slope, at, u, p);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real predicted = iso_adams_increment(&iso_table_ab4, h, kept[s], kept + n + s, n, ISO_AB4_STEPS);
        const real corrected = iso_adams_increment(&iso_table_am[3], h, slope[s], kept + s, n, ISO_AB4_STEPS);
        error = iso_larger(error, corrected - predicted);
        iso_advance(trail, s, corrected);
    }
    if (evaluate_last) {
        f(slope, trail->x, u, p);
    }
    iso_keep_slope(trail, slope);
    return (real)iso_table_milne.b[0] / (real)iso_table_milne.over * error;
}

/* Fills the kept slopes with that of x, as if the motion had been even: for stiff plants, whose past cannot be computed.
 * Only a check looks at them, and tells too much until they are real. slope[n]. */
static inline void iso_prime_constant(const iso_trail *const trail, iso_derivative *const f, const real h,
                                      const real *restrict const u, const real *restrict const p,
                                      real *restrict const slope)
{
    f(slope, trail->x, u, p);
    for (size_t s = 0; s < trail->n && trail->moved != NULL; s++) {
        trail->moved[s] = h * slope[s];
        for (size_t j = 0; j < trail->kept; j++) {
            trail->slopes[j * trail->n + s] = slope[s];
        }
    }
}

/* Fills what the trail keeps by integrating backwards from x with rk4, so that the first step costs what every step
 * costs: `skip` slopes of x itself first, then those at t - h, t - 2h, ... They are exact to h^5, which keeps the fourth
 * order. x is left as it is. at[n], work[ISO_EXPLICIT_WORK(n)]. */
static inline void iso_prime_slopes(const iso_trail *const trail, iso_derivative *const f, const real h,
                                    const real *restrict const u, const real *restrict const p, const bool from_now,
                                    real *restrict const at, real *restrict const work)
{
    const size_t n = trail->n;
    const iso_trail back = {.n = n, .x = at};
    memcpy(at, trail->x, n * sizeof *at);
    for (size_t past = 0; past < trail->kept; past++) {
        if (past > 0 || !from_now) {
            (void)iso_explicit_step(&iso_tableau_rk4, &back, f, -h, u, p, work);
        }
        f(trail->slopes + past * n, at, u, p);
        for (size_t s = 0; s < n && past == 0 && trail->moved != NULL; s++) {
            trail->moved[s] = trail->x[s] - at[s];
        }
    }
}

#endif
