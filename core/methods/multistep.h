/* Adams methods of order four with a fixed step, on derivatives kept from the steps before. */
#ifndef ISO_CORE_METHODS_MULTISTEP_H
#define ISO_CORE_METHODS_MULTISTEP_H

#include "core/methods/explicit.h"

/* Sums kept: what the derivatives so far add to the next step; of abm4 first to its predictor, then to its corrector.
 */
enum {
    ISO_AB4_SUMS = ISO_AB4_STEPS - 1,
    ISO_ABM4_PREDICTOR = ISO_AB4_STEPS,
    ISO_ABM4_CORRECTOR = ISO_AB4_STEPS - 1,
    ISO_ABM4_SUMS = ISO_ABM4_PREDICTOR + ISO_ABM4_CORRECTOR,
};

ISO_INLINE void iso_ab4_take_derivative(const iso_history *const history, const real h, const real *const derivative)
{
    iso_take_derivative(&iso_table_ab4, 1, ISO_AB4_SUMS, h, history->n, derivative, history->past);
}

ISO_INLINE void iso_abm4_take_derivative(const iso_history *const history, const real h, const real *const derivative)
{
    const size_t n = history->n;
    iso_take_derivative(&iso_table_ab4, 0, ISO_ABM4_PREDICTOR, h, n, derivative, history->past);
    iso_take_derivative(&iso_table_am[3], 1, ISO_ABM4_CORRECTOR, h, n, derivative,
                        history->past + ISO_ABM4_PREDICTOR * n);
}

/* Adams-Bashforth, one evaluation: x += h / 24 (55 f - 59 f[-1] + 37 f[-2] - 9 f[-3]). Local error 251/720 h^5 x^(5).
 * history->past[ISO_AB4_SUMS n], work[n]. Returns the local error of the step before, where steps are checked. */
ISO_INLINE real iso_ab4_step(const iso_history *const history, iso_derivative *const f, const real h,
                             const real *restrict const u, const real *restrict const p, real *restrict const work)
{
    const real weight = iso_weight(&iso_table_ab4, h, 0);
    f(work, history->x, u, p);
    const real error = iso_check(history, h, work, NULL);
    iso_keep_derivative(history, h, work);
    ISO_UNROLL
    for (size_t s = 0; s < history->n; s++) {
        iso_advance(history, s, weight * work[s] - history->past[s]);
    }
    iso_ab4_take_derivative(history, h, work);
    return error;
}

/* Adams-Bashforth-Moulton: predict, then evaluate and correct `corrections` times, then evaluate once more if
 * `evaluate_last`: P(EC)^m or P(EC)^m E. Local error -19/720 h^5 x^(5). history->past[ISO_ABM4_SUMS n], work[2 n].
 * Returns Milne's estimate of it, of this very step: 19/270 of the largest difference between predictor and corrector.
 */
ISO_INLINE real iso_abm4_step(const iso_history *const history, iso_derivative *const f, const real h,
                              const real *restrict const u, const real *restrict const p, real *restrict const work,
                              const uint8_t corrections, const bool evaluate_last)
{
    const size_t n = history->n;
    const real *const predicted = history->past;
    const real *const corrector = history->past + ISO_ABM4_PREDICTOR * n;
    const real weight = iso_weight(&iso_table_am[3], h, 0);
    real *const derivative = work;
    real *const at = work + n;
    real error = R(0.0);

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        at[s] = history->x[s] + predicted[s];
    }
    ISO_UNROLL
    for (uint8_t i = 1; i < corrections; i++) {
        f(derivative, at, u, p);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = history->x[s] + (weight * derivative[s] + corrector[s]);
        }
    }
    f(derivative, at, u, p);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real corrected = weight * derivative[s] + corrector[s];
        error = iso_larger(error, corrected - predicted[s]);
        iso_advance(history, s, corrected);
    }
    if (evaluate_last) {
        f(derivative, history->x, u, p);
    }
    iso_abm4_take_derivative(history, h, derivative);
    return (real)iso_table_milne.b[0] / (real)iso_table_milne.over * error;
}

/* Reals of work space for priming: the derivatives, the increment and a state of walking back, and its stages. */
#define ISO_PRIME_WORK(n) ((ISO_ADAMS_DERIVATIVES + 2) * (n) + ISO_EXPLICIT_WORK(n))

/* The derivatives of the motion that leads to x, by integrating backwards with rk4: `count` of them, the newest first,
 * that of x itself if `from_now`, or else that at t - h. They are exact to h^5, which keeps the fourth order. moved[n]
 * is the increment from t - h to x. derivatives[count n], at[n], work[ISO_EXPLICIT_WORK(n)]. */
static inline void iso_walk_back(const size_t n, iso_derivative *const f, const real h, const real *const x,
                                 const real *restrict const u, const real *restrict const p, const uint8_t count,
                                 const bool from_now, real *restrict const derivatives, real *restrict const moved,
                                 real *restrict const at, real *restrict const work)
{
    const iso_history back = {.n = n, .x = at};
    memcpy(at, x, n * sizeof *at);
    for (size_t past = 0; past < count; past++) {
        if (past > 0 || !from_now) {
            (void)iso_explicit_step(&iso_tableau_rk4, &back, f, -h, u, p, work);
        }
        f(derivatives + past * n, at, u, p);
        for (size_t s = 0; s < n && past == 0; s++) {
            moved[s] = x[s] - at[s];
        }
    }
}

#endif
