/* Explicit one-step methods: one loop over a Butcher table (core/methods/tableau.h).
 *
 * With the table and n known at compile time the loops unroll and the table turns into constants; no branch, index or
 * loop count depends on x, u or p. Called with n known only at run time it gives the same bits.
 */
#ifndef ISO_CORE_METHODS_EXPLICIT_H
#define ISO_CORE_METHODS_EXPLICIT_H

#include <stdbool.h>

#include "core/methods/history.h"

/* Reals of work space for n states: the derivatives of all stages, and the state of one. */
#define ISO_EXPLICIT_WORK(n) ((ISO_STAGES_MAX + 1) * (n))

/* h / over * (c[0] k[0] + c[1] k[n] + ...) over the terms with c != 0. At least one c is not zero. */
static inline real iso_combine(const real h_over, const int8_t *const c, const uint8_t terms, const real *const k,
                               const size_t n)
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
    return h_over * sum;
}

/* One step of h: k_i = f(x + h sum_j a_ij k_j), x += h sum_i b_i k_i. u and p are held. work[ISO_EXPLICIT_WORK(n)],
 * less for fewer stages. Local error of order h^(order + 1). Butcher (2016), Numerical Methods for Ordinary
 * Differential Equations, eqs. 221a-d. Returns the local error of the step before, where steps are checked. */
ISO_INLINE real iso_explicit_step(const iso_tableau *const table, const iso_history *const history,
                                  iso_derivative *const f, const real h, const real *restrict const u,
                                  const real *restrict const p, real *restrict const work)
{
    const size_t n = history->n;
    real *const k = work;
    real *const at = work + table->stages * n;

    f(k, history->x, u, p);
    const real error = iso_check(history, h, k, NULL);
    iso_keep_derivative(history, h, k);
    ISO_UNROLL
    for (uint8_t i = 1; i < table->stages; i++) {
        const real h_over = h / (real)table->a_over[i];
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = history->x[s] + iso_combine(h_over, table->a[i], i, k + s, n);
        }
        f(k + i * n, at, u, p);
    }

    const real h_over = h / (real)table->b_over;
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        iso_advance(history, s, iso_combine(h_over, table->b, table->stages, k + s, n));
    }
    return error;
}

/* One step of h of semi-implicit Euler for a mechanical plant: v += h a(q, v) for the speeds v, then q += h q'(q, v)
 * for the positions q, with the new speeds. Symplectic where q' = v, the mass matrix is constant and a comes from a
 * potential of q; elsewhere the energy drifts, as with any method of order one (tests/hard/long_run.c). Vogelaere
 * (1956), Methods of integration which preserve the contact transformation property; Hairer, Lubich, Wanner (2006),
 * Geometric Numerical Integration, eq. I.1.9. work[n]. */
static inline real iso_semi_implicit_step(const iso_history *const history, const iso_equations *const eq, const real h,
                                          const real *restrict const u, const real *restrict const p,
                                          real *restrict const work)
{
    const size_t positions = eq->rates == NULL ? history->n / 2 : eq->positions;
    eq->derivative(work, history->x, u, p);
    const real error = iso_check(history, h, work, NULL);
    iso_keep_derivative(history, h, work);
    ISO_UNROLL
    for (size_t s = positions; s < history->n; s++) {
        iso_advance(history, s, h * work[s]);
    }
    if (eq->rates != NULL) {
        eq->rates(work, history->x, u, p);
    }
    ISO_UNROLL
    for (size_t s = 0; s < positions; s++) {
        iso_advance(history, s, h * (eq->rates == NULL ? history->x[positions + s] : work[s]));
    }
    return error;
}

#endif
