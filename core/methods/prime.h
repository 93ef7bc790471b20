/* Priming: computes the history of a method, before the first step and after a discontinuity. */
#ifndef ISO_CORE_METHODS_PRIME_H
#define ISO_CORE_METHODS_PRIME_H

#include "core/methods/rk4.h"

/* Vectors of work space for priming: the derivatives, the increment, and the state and the stages of the backward
 * integration. */
enum { ISO_PRIME_VECTORS = ISO_ADAMS_DERIVATIVES + 2 + ISO_RK4_VECTORS };

/* The derivatives of the motion that leads to x, by integrating backwards with rk4: `count` of them, the newest first,
 * that of x itself if `from_now`, or else that at t - h. They are exact to h^5, which keeps the fourth order. Returns
 * them as [count n] in step->work[ISO_PRIME_VECTORS n], behind the increment from t - h to x. */
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
            iso_step_begin(&back);
            iso_explicit_step(&iso_tableau_rk4, &back);
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

/* For a centred check: goes back as many steps as it looks at, and makes them by rk4. work[(1 + ISO_RK4_VECTORS) n].
 */
static inline void iso_prime_centred(iso_step *const step)
{
    const size_t n = step->history->n;
    real *const at = step->work;
    const iso_history unseen = {.n = n, .x = at};
    const iso_history watch = {
        .n = n, .x = at, .check = step->history->check, .checked = ISO_CENTRED_KEPT, .centred = true};
    iso_step walk = *step;
    walk.work = step->work + n;
    walk.degree = 0;
    memcpy(at, step->history->x, n * sizeof *at);
    memset(watch.check, 0, ISO_CENTRED_KEPT * n * sizeof *at);
    for (int i = 0; i < 2 * ISO_CENTRED_KEPT; i++) {
        const bool back = i < ISO_CENTRED_KEPT;
        walk.history = back ? &unseen : &watch;
        walk.h = back ? -step->h : step->h;
        iso_step_begin(&walk);
        iso_explicit_step(&iso_tableau_rk4, &walk);
    }
}

/* For an explicit method without a history, whose steps may be checked. */
static inline void iso_prime_check(iso_step *const step)
{
    if (step->history->centred) {
        iso_prime_centred(step);
        return;
    }
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
