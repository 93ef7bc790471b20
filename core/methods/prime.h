/* Priming: computes the history of a method, before the first step and after a discontinuity. */
#ifndef ISO_CORE_METHODS_PRIME_H
#define ISO_CORE_METHODS_PRIME_H

#include "core/methods/rk4.h"

/* Vectors of work space for priming: the derivatives, the increment, and the state and the stages of the backward
 * integration. */
enum { ISO_PRIME_VECTORS = ISO_ADAMS_DERIVATIVES + 2 + ISO_EXPLICIT_VECTORS };

/* The derivatives of the motion that leads to x, by integrating backwards with rk4: `count` of them, the newest first,
 * that of x itself if `from_now`, or else that at t - h. They are exact to h^5, which keeps the fourth order. Returns them
 * as [count n] in step->work[ISO_PRIME_VECTORS n], behind the increment from t - h to x. */
static inline const real *iso_walk_back(const iso_step *const step, const uint8_t count, const bool from_now)
{
    const size_t n = step->history->n;
    const real *const x = step->history->x;
    real *const moved = step->work;
    real *const derivatives = step->work + n;
    real *const at = derivatives + ISO_ADAMS_DERIVATIVES * n;
    const iso_history history = {.n = n, .x = at};
    iso_step back = {.history = &history,
                     .equations = step->equations,
                     .f = step->f,
                     .h = -step->h,
                     .u = step->u,
                     .p = step->p,
                     .work = at + n};
    memcpy(at, x, n * sizeof *at);
    for (size_t past = 0; past < count; past++) {
        if (past > 0 || !from_now) {
            iso_step_begin(&back, R(0.0));
            iso_rk4_step(&back);
        }
        iso_evaluate(step, derivatives + past * n, at);
        for (size_t s = 0; s < n && past == 0; s++) {
            moved[s] = x[s] - at[s];
        }
    }
    return derivatives;
}

/* Gives the first check the increment that led to x. */
static inline void iso_keep_moved(const iso_step *const step)
{
    const iso_history *const history = step->history;
    for (size_t s = 0; s < history->n && history->checked > 0; s++) {
        history->check[s] = step->work[s] - history->check[s];
    }
}

/* For an explicit method without a history, whose steps may be checked. */
static inline void iso_prime_check(iso_step *const step)
{
    const uint8_t count = step->history->checked;
    const real *const derivatives = iso_walk_back(step, count, false);
    for (uint8_t past = count; past-- > 0;) {
        iso_keep_derivative(step->history, step->h, derivatives + past * step->history->n);
    }
    iso_keep_moved(step);
}

/* The same for a stiff plant, which cannot be integrated backwards: assumes a constant derivative. The first checks
 * overestimate the error. work[n]. */
static inline void iso_prime_even(iso_step *const step)
{
    const iso_history *const history = step->history;
    real *const derivative = step->work;
    if (history->checked > 0) {
        iso_evaluate(step, derivative, history->x);
        for (uint8_t past = 0; past < history->checked; past++) {
            iso_keep_derivative(history, step->h, derivative);
        }
        for (size_t s = 0; s < history->n; s++) {
            history->check[s] = step->h * derivative[s] - history->check[s];
        }
    }
}

#endif
