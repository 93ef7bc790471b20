/* Explicit one-step methods: one loop over a Butcher table (core/tableau.h).
 *
 * With the table and n known at compile time the loops unroll and the table turns into constants; no branch, index or
 * loop count depends on x, u or p. Called with n known only at run time it gives the same bits.
 */
#ifndef ISO_CORE_EXPLICIT_H
#define ISO_CORE_EXPLICIT_H

#include <stdbool.h>

#include "core/plant.h"
#include "core/tableau.h"
#include "core/unroll.h"

/* Reals of work space for n states: the slopes of all stages, and the state of one. */
#define ISO_EXPLICIT_WORK(n) ((ISO_STAGES_MAX + 1) * (n))

/* x[i] + h / over * (c[0] k[0][i] + c[1] k[1][i] + ...) over the terms with c != 0. At least one c is not zero. */
static inline real iso_combine(const real x, const real h_over, const int8_t *const c, const uint8_t terms,
                               const real *const k, const size_t n)
{
    real sum = R(0.0);
    bool first = true;
    ISO_UNROLL
    for (uint8_t j = 0; j < terms; j++) {
        if (c[j] != 0) {
            const real term = (real)c[j] * k[j * n];
            sum = first ? term : sum + term;
            first = false;
        }
    }
    return x + h_over * sum;
}

/* Advances x[n] by h: k_i = f(x + h sum_j a_ij k_j), x += h sum_i b_i k_i. u and p are held.
 * work[ISO_EXPLICIT_WORK(n)]. Local error of order h^(order + 1). Butcher (2016), eqs. 221a-d. */
static inline void iso_explicit_step(const iso_tableau *const table, const size_t n, iso_derivative *const f,
                                     const real h, real *restrict const x, const real *restrict const u,
                                     const real *restrict const p, real *restrict const work)
{
    real *const k = work;
    real *const at = work + table->stages * n;

    f(k, x, u, p);
    ISO_UNROLL
    for (uint8_t i = 1; i < table->stages; i++) {
        const real h_over = h / (real)table->a_over[i];
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = iso_combine(x[s], h_over, table->a[i], i, k + s, n);
        }
        f(k + i * n, at, u, p);
    }

    const real h_over = h / (real)table->b_over;
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        x[s] = iso_combine(x[s], h_over, table->b, table->stages, k + s, n);
    }
}

#endif
