/* Implicit methods for stiff plants: the fourth-order backward differentiation formula and a linearly implicit method.
 *
 * Both solve with 1 - hb J, whose factors a plant computes from its analytic Jacobian J = df/dx, without a pivot
 * search: time and order of operations do not depend on data.
 */
#ifndef ISO_CORE_METHODS_STIFF_H
#define ISO_CORE_METHODS_STIFF_H

#include "core/methods/history.h"

/* Reals of work space for n states, beside the factors. */
#define ISO_BDF4_WORK(n) (4 * (n))
#define ISO_ROSENBROCK_WORK(n) (5 * (n))
#define ISO_BDF4_PRIME_WORK(n) (2 * (n) + ISO_ROSENBROCK_WORK(n))

/* Puts an increment before the kept ones. */
static inline void iso_keep_increment(const iso_history *const history, const size_t s, const real dx)
{
    ISO_UNROLL
    for (size_t j = ISO_BDF4_STEPS; j-- > 1;) {
        history->increments[j * history->n + s] = history->increments[(j - 1) * history->n + s];
    }
    history->increments[s] = dx;
}

/* The sum of `terms` whole multiples of the kept increments of state s. */
static inline real iso_past_increments(const iso_history *const history, const size_t s, const int8_t *const c,
                                       const uint8_t terms)
{
    real sum = (real)c[0] * history->increments[s];
    ISO_UNROLL
    for (uint8_t j = 1; j < terms; j++) {
        sum += (real)c[j] * history->increments[j * history->n + s];
    }
    return sum;
}

/* One step of h of the backward differentiation formula (iso_table_bdf4), by `iterations` Newton iterations from the
 * predictor with the Jacobian there. lu[eq->factors], work[ISO_BDF4_WORK(n)]. *residual is the largest part of the last
 * correction. Returns the local error of this step: the difference to the predictor is h^5 x^(5), since the kept
 * increments are those of the formula, and its error constant over sigma(1) is 1/5 (Hairer, Norsett, Wanner 1993,
 * III.2). */
static inline real iso_bdf4_step(const iso_history *const history, const iso_equations *const eq, const real h,
                                 const real *restrict const u, const real *restrict const p, real *restrict const lu,
                                 real *restrict const work, const uint8_t iterations, real *const residual)
{
    const iso_bdf *const table = &iso_table_bdf4;
    const size_t n = history->n;
    const real hb = h * ((real)table->derivative / (real)table->over);
    real *const at = work;
    real *const g = work + n;
    real *const past = work + 2 * n;
    real *const dx = work + 3 * n;
    real error = R(0.0);

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        dx[s] = iso_past_increments(history, s, table->predictor, ISO_BDF4_STEPS);
        at[s] = history->x[s] + dx[s];
        past[s] = R(1.0) / (real)table->over * iso_past_increments(history, s, table->b, ISO_BDF4_STEPS - 1);
    }
    eq->factor(lu, at, u, p, hb);

    /* (1 - hb J) correction = past + hb f(x + dx) - dx; the increment is summed up by itself, since x would swallow
     * corrections below half of its ulp. */
    for (uint8_t i = 0; i < iterations; i++) {
        *residual = R(0.0);
        eq->derivative(g, at, u, p);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            g[s] = (past[s] + hb * g[s]) - dx[s];
        }
        eq->solve(g, lu);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            dx[s] += g[s];
            at[s] = history->x[s] + dx[s];
            *residual = iso_larger(*residual, g[s]);
        }
    }

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        error = iso_larger(error, dx[s] - iso_past_increments(history, s, table->predictor, ISO_BDF4_STEPS));
        iso_keep_increment(history, s, dx[s]);
        iso_advance(history, s, dx[s]);
    }
    return R(0.2) * error;
}

/* One step of h of the linearly implicit method iso_table_ros3: two evaluations, one Jacobian, three solutions.
 * lu[eq->factors], work[ISO_ROSENBROCK_WORK(n)]. Local error of order h^4. Returns the local error of the step before,
 * where steps are checked, seen through (1 - h gamma J)^-1, which takes the stiff part out of the derivatives (Shampine
 * and Baca 1984, Error estimators for stiff differential equations). */
static inline real iso_rosenbrock_step(const iso_history *const history, const iso_equations *const eq, const real h,
                                       const real *restrict const u, const real *restrict const p,
                                       real *restrict const lu, real *restrict const work)
{
    const iso_rosenbrock *const table = &iso_table_ros3;
    const size_t n = history->n;
    const real h_gamma = h * table->gamma;
    real *const derivative = work;
    real *const k1 = work + n;
    real *const k2 = work + 2 * n;
    real *const k3 = work + 3 * n;
    real *const at = work + 4 * n;
    real error = R(0.0);

    eq->derivative(derivative, history->x, u, p);
    eq->factor(lu, history->x, u, p, h_gamma);
    if (history->checked > 0) {
        (void)iso_check(history, h, derivative, at);
        eq->solve(at, lu);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            error = iso_larger(error, at[s]);
        }
    }
    iso_keep_derivative(history, h, derivative);

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k1[s] = h_gamma * derivative[s];
    }
    eq->solve(k1, lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        at[s] = history->x[s] + table->a21 * k1[s];
    }
    eq->derivative(derivative, at, u, p);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k2[s] = h_gamma * derivative[s] + table->gamma * table->c21 * k1[s];
    }
    eq->solve(k2, lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k3[s] = h_gamma * derivative[s] + (table->gamma * table->c31 * k1[s] + table->gamma * table->c32 * k2[s]);
    }
    eq->solve(k3, lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        iso_advance(history, s, (table->m[0] * k1[s] + table->m[1] * k2[s]) + table->m[2] * k3[s]);
    }
    return error;
}

/* What a step of the linearly implicit method that is about to begin is held against, as if the motion had been even:
 * the past of a stiff plant cannot be computed. The first checks tell too much. derivative[n]. */
static inline void iso_prime_constant(const iso_history *const history, iso_derivative *const f, const real h,
                                      const real *restrict const u, const real *restrict const p,
                                      real *restrict const derivative)
{
    if (history->checked > 0) {
        f(derivative, history->x, u, p);
        for (uint8_t past = 0; past < history->checked; past++) {
            iso_keep_derivative(history, h, derivative);
        }
        for (size_t s = 0; s < history->n; s++) {
            history->check[s] = h * derivative[s] - history->check[s];
        }
    }
}

/* Fills the kept increments before the first step. The past of a stiff plant cannot be computed, so the linearly
 * implicit method looks ahead by five steps, each in sub-steps, and the polynomial of degree four through their ends is
 * continued to the past. It does not go through the state itself, which may lie off the smooth solution, before a layer
 * that no step resolves: the formula then starts on the solution beyond the layer, and keeps its order. Local errors of
 * order four and an extrapolation exact to h^5, both made only here, keep it too. x is left as it is. lu[eq->factors],
 * work[ISO_BDF4_PRIME_WORK(n)]. */
static inline void iso_bdf4_prime(const iso_history *const history, const iso_equations *const eq, const real h,
                                  const real *restrict const u, const real *restrict const p, real *restrict const lu,
                                  real *restrict const work)
{
    enum { AHEAD = ISO_BDF4_STEPS + 1, SUBSTEPS = 2 };
    const size_t n = history->n;
    real *const at = work;
    real *const compensation = work + n;
    const iso_history ahead = {.n = n, .x = at, .compensation = compensation};
    memcpy(at, history->x, n * sizeof *at);
    for (size_t step = 0; step < AHEAD; step++) {
        real *const increment =
            history->increments + (step > 0 ? step - 1 : 0) * n; /* that of the first is of no use */
        memcpy(increment, at, n * sizeof *at);
        memset(compensation, 0, n * sizeof *compensation);
        for (int i = 0; i < SUBSTEPS; i++) {
            (void)iso_rosenbrock_step(&ahead, eq, h / (real)SUBSTEPS, u, p, lu, compensation + n);
        }
        for (size_t s = 0; s < n; s++) {
            increment[s] = (at[s] - increment[s]) + compensation[s];
        }
    }
    /* Backwards in time they stand as a method keeps them, the nearest first. So the predictor continues them to the
     * past, and what it leaves is turned about. */
    for (size_t s = 0; s < n; s++) {
        for (size_t step = 0; step < AHEAD; step++) {
            iso_keep_increment(history, s, iso_past_increments(history, s, iso_table_bdf4.predictor, ISO_BDF4_STEPS));
        }
        for (size_t j = 0; j < ISO_BDF4_STEPS / 2; j++) {
            real *const newer = history->increments + j * n + s;
            real *const older = history->increments + (ISO_BDF4_STEPS - 1 - j) * n + s;
            const real swap = *newer;
            *newer = *older;
            *older = swap;
        }
    }
}

#endif
