/* A linearly implicit (Rosenbrock) method of order three for stiff plants: two evaluations, one Jacobian, three
 * solutions.
 *
 * It solves with 1 - h gamma J, whose factors a plant computes from its analytic Jacobian J = df/dx, without a pivot
 * search: time and order of operations do not depend on data.
 */
#ifndef ISO_CORE_METHODS_ROSENBROCK_H
#define ISO_CORE_METHODS_ROSENBROCK_H

#include "core/methods/step.h"

/* A linearly implicit method: (1 - h gamma J) k_i = h gamma (f(t + alpha_i h, x + sum_j a_ij k_j) + gamma_i h f_t +
 * sum_j c_ij k_j / h), x += sum_i m_i k_i, where f_t is df/dt at the start. Hairer and Wanner (1996), Solving Ordinary
 * Differential Equations II, eq. IV.7.25. */
enum { ISO_ROSENBROCK_STAGES = 3 };

typedef struct iso_rosenbrock {
    iso_scalar gamma;
    iso_scalar gammas[ISO_ROSENBROCK_STAGES]; /* gamma_i; alpha_i is 0, then gamma */
    iso_scalar a21; /* also a31; a32 is zero, so that the second and third stage share an evaluation */
    iso_scalar c21, c31, c32;
    iso_scalar m[ISO_ROSENBROCK_STAGES];
} iso_rosenbrock;

/* ROS3, order three, L-stable: Sandu, Verwer, Blom, Spee, Carmichael, Potra (1997), Atmospheric Environment 31(20),
 * 3459-3472. */
static const iso_rosenbrock iso_table_ros3 = {
    .gamma = ISO_SCALAR(0.43586652150845899942),
    .gammas = {ISO_SCALAR(0.43586652150845899942), ISO_SCALAR(0.24291996454816804366),
               ISO_SCALAR(2.1851380027664058512)},
    .a21 = ISO_SCALAR(1.0),
    .c21 = ISO_SCALAR(-1.0156171083877702092),
    .c31 = ISO_SCALAR(4.0759956452537699825),
    .c32 = ISO_SCALAR(9.2076794298330791242),
    .m = {ISO_SCALAR(1.0), ISO_SCALAR(6.1697947043828245593), ISO_SCALAR(-0.42772256543218573326)},
};

/* h f_t = f(x, u + h u') - f(x, u), u' the rate of the inputs: one evaluation, exact where f is affine in its inputs,
 * as with efforts. Elsewhere half the difference of f(x, u + h u') and f(x, u - h u'), exact to h^3: two. `other` is
 * [n] of work space. */
ISO_INLINE void iso_input_drift(const iso_step *const step, const real *const derivative, real *const drift,
                                real *const other)
{
    const iso_equations *const eq = step->equations;
    real *const at = iso_inputs_room(step);
    iso_input_ahead(eq, step->degree, R(1.0), step->u, at);
    step->f(drift, step->history->x, at, step->p);
    if (eq->curved) {
        iso_input_ahead(eq, step->degree, R(-1.0), step->u, at);
        step->f(other, step->history->x, at, step->p);
    }
    ISO_UNROLL
    for (size_t s = 0; s < step->history->n; s++) {
        drift[s] = eq->curved ? R(0.5) * (drift[s] - other[s]) : drift[s] - derivative[s];
    }
}

/* One step of iso_table_ros3. work[ISO_ROSENBROCK_VECTORS n], and one
 * more where inputs are smooth. Local error of order h^4. */
enum { ISO_ROSENBROCK_VECTORS = 5 };

/* h gamma (f + gamma_i h f_t) of a stage. */
ISO_INLINE real iso_rosenbrock_slope(const iso_step *const step, const size_t stage, const real derivative,
                                     const real *const drift)
{
    const real h_gamma = step->h * iso_table_ros3.gamma;
    return step->degree == 0 ? h_gamma * derivative : h_gamma * (derivative + iso_table_ros3.gammas[stage] * *drift);
}

ISO_INLINE void iso_rosenbrock_step(iso_step *const step)
{
    const iso_rosenbrock *const table = &iso_table_ros3;
    const iso_history *const history = step->history;
    const iso_equations *const eq = step->equations;
    const size_t n = history->n;
    real *const derivative = step->work;
    real *const k1 = step->work + n;
    real *const k2 = step->work + 2 * n;
    real *const k3 = step->work + 3 * n;
    real *const at = step->work + 4 * n;
    real *const drift = step->work + 5 * n;

    iso_step_factored(step, step->h * table->gamma);
    if (step->degree > 0) {
        iso_input_drift(step, derivative, drift, at);
    }
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k1[s] = iso_rosenbrock_slope(step, 0, derivative[s], drift + s);
    }
    eq->solve(k1, step->lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        at[s] = history->x[s] + table->a21 * k1[s];
    }
    iso_evaluate_at(step, iso_all(table->gamma), derivative, at);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k2[s] = iso_rosenbrock_slope(step, 1, derivative[s], drift + s) + table->gamma * table->c21 * k1[s];
    }
    eq->solve(k2, step->lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        k3[s] = iso_rosenbrock_slope(step, 2, derivative[s], drift + s) +
                (table->gamma * table->c31 * k1[s] + table->gamma * table->c32 * k2[s]);
    }
    eq->solve(k3, step->lu);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        iso_advance(history, s, (table->m[0] * k1[s] + table->m[1] * k2[s]) + table->m[2] * k3[s]);
    }
}

/* The columns of core/methods/table.h. */
#define ISO_ROSENBROCK_ORDER(r) 3
#define ISO_ROSENBROCK_STAGES(r) 0
#define ISO_ROSENBROCK_TABLEAU NULL
#define ISO_ROSENBROCK_EVALUATIONS(r) (2 + ISO_IS_SMOOTH(r))
#define ISO_ROSENBROCK_SOLUTIONS(r) (3 + ISO_IS_CHECKED(r))
#define ISO_ROSENBROCK_PAST(r) 0
#define ISO_ROSENBROCK_WORK(r) (ISO_ROSENBROCK_VECTORS + ISO_IS_SMOOTH(r))
#define ISO_ROSENBROCK_PRIME(r) 1
#define ISO_ROSENBROCK_PRIMES(r) iso_prime_even
#define ISO_ROSENBROCK_SUMS(r) (6 + 4 * ISO_IS_SMOOTH(r))
#define ISO_ROSENBROCK_PRODUCTS(r) (8 + 3 * ISO_IS_SMOOTH(r))
#define ISO_ROSENBROCK_KIND(r) ISO_FROM_START

#endif
