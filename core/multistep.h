/* Adams-Bashforth of order four: one evaluation a step, on slopes kept from the three steps before. */
#ifndef ISO_CORE_MULTISTEP_H
#define ISO_CORE_MULTISTEP_H

#include "core/explicit.h"

/* Reals of history for n states: the slopes at t - h, t - 2h, t - 3h, the newest first. */
#define ISO_AB4_HISTORY(n) ((ISO_AB4_STEPS - 1) * (n))

/* Fills history[ISO_AB4_HISTORY(n)] by integrating backwards from x with rk4, so that the first step costs what every
 * step costs; the slopes are exact to h^5, which keeps the fourth order. x is left as it is.
 * at[n], work[ISO_EXPLICIT_WORK(n)]. */
static inline void iso_ab4_prime(const size_t n, iso_derivative *const f, const real h, const real *restrict const x,
                                 const real *restrict const u, const real *restrict const p,
                                 real *restrict const history, real *restrict const at, real *restrict const work)
{
    memcpy(at, x, n * sizeof *at);
    for (size_t past = 0; past < ISO_AB4_STEPS - 1; past++) {
        iso_explicit_step(&iso_tableau_rk4, n, f, -h, at, u, p, work);
        f(history + past * n, at, u, p);
    }
}

/* Advances x[n] by h: x += h / 24 (55 f - 59 f[-1] + 37 f[-2] - 9 f[-3]), and moves the history on. slope[n] is work
 * space. Local error 251/720 h^5 x^(5). */
static inline void iso_ab4_step(const size_t n, iso_derivative *const f, const real h, real *restrict const x,
                                const real *restrict const u, const real *restrict const p,
                                real *restrict const history, real *restrict const slope)
{
    const int8_t *const b = iso_table_ab4.b;
    const real h_over = h / (real)iso_table_ab4.over;

    f(slope, x, u, p);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real now = slope[s];
        const real f1 = history[s];
        const real f2 = history[n + s];
        const real f3 = history[2 * n + s];
        x[s] += h_over * ((((real)b[0] * now + (real)b[1] * f1) + (real)b[2] * f2) + (real)b[3] * f3);
        history[s] = now;
        history[n + s] = f1;
        history[2 * n + s] = f2;
    }
}

#endif
