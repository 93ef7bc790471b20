/* What the functions of methods/method.c share: the equations, the memory of a run, and the list of recipes. Those of a
 * recipe that the compiler knows stand in a file for each method, as in a plant: with all kernels in one it takes
 * twenty times as long. */
#ifndef ISO_TESTS_UNIT_METHOD_RUN_H
#define ISO_TESTS_UNIT_METHOD_RUN_H

#include "core/methods/dense.h"
#include "core/methods/primed.h"

/* Most is kept by ab4, checked and compensated; a file of one method has no row of another (method.c compares). */
enum { N = 4, FACTORS = N * N, STATE_MAX = 10 * N, WORK_MAX = ISO_PRIME_VECTORS * N };

/* How often the equations were called. */
typedef struct call_counts {
    unsigned derivative, factor, solve;
} call_counts;

extern call_counts calls;

/* Henon and Heiles (1964): q1'' = -q1 - 2 q1 q2, q2'' = -q2 - q1^2 + q2^2. Every rounding shows. */
static inline void derivative(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    calls.derivative++;
    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = -x[0] - R(2.0) * (x[0] * x[1]);
    dx[3] = (x[1] * x[1] - x[0] * x[0]) - x[1];
}

static inline void factor(real *restrict lu, const real *restrict x, const real *restrict u, const real *restrict p,
                          const real hb)
{
    (void)u;
    (void)p;
    calls.factor++;
    memset(lu, 0, FACTORS * sizeof *lu);
    lu[0 * N + 2] = R(1.0);
    lu[1 * N + 3] = R(1.0);
    lu[2 * N + 0] = R(-1.0) - R(2.0) * x[1];
    lu[2 * N + 1] = R(-2.0) * x[0];
    lu[3 * N + 0] = R(-2.0) * x[0];
    lu[3 * N + 1] = R(2.0) * x[1] - R(1.0);
    iso_dense_factor(lu, N, hb);
}

static inline void solve(real *restrict d, const real *restrict lu)
{
    calls.solve++;
    iso_dense_solve(d, lu, N);
}

static const iso_equations equations = {.derivative = derivative, .factor = factor, .solve = solve, .factors = FACTORS};

/* All the memory of a run. */
typedef struct run {
    real x[STATE_MAX + 1];
    real work[WORK_MAX + 1];
    real lu[FACTORS + 1];
    iso_any_progress progress;
} run;

typedef void prime_function(run *r, real h);
typedef void step_function(run *r, real h);

/* The two functions of a recipe that the compiler knows. Priming is cold: unrolled it would take long to compile. */
#define FIXED(name, recipe)                                                                                            \
    __attribute__((cold)) void prime_##name(run *const r, const real h)                                                \
    {                                                                                                                  \
        iso_method_prime(recipe, N, &equations, h, r->x, NULL, NULL, r->lu, r->work, &r->progress.progress);           \
    }                                                                                                                  \
    void step_##name(run *const r, const real h)                                                                       \
    {                                                                                                                  \
        iso_method_step(recipe, N, &equations, h, r->x, NULL, NULL, r->lu, r->work, &r->progress.progress);            \
    }

/* name, recipe, and a step's evaluations, Jacobians and solutions. */
#define BOTH (ISO_COMPENSATED | ISO_CHECKED)
#define RECIPES(X)                                                                                                     \
    X(euler, ISO_EULER, 1, 0, 0)                                                                                       \
    X(heun, ISO_HEUN, 2, 0, 0)                                                                                         \
    X(rk4, ISO_RK4, 4, 0, 0)                                                                                           \
    X(ab4, ISO_AB4, 1, 0, 0)                                                                                           \
    X(semi_implicit, ISO_SEMI_IMPLICIT, 1, 0, 0)                                                                       \
    X(abm4, ISO_ABM4, 2, 0, 0)                                                                                         \
    X(abm4_pec, ISO_ABM4_PEC, 1, 0, 0)                                                                                 \
    X(abm4_pecece, ISO_ABM4_PECECE, 3, 0, 0)                                                                           \
    X(bdf4, ISO_BDF4, 2, 1, 2)                                                                                         \
    X(bdf4_once, ISO_BDF4 | ISO_ITERATIONS(1), 1, 1, 1)                                                                \
    X(rosenbrock, ISO_ROSENBROCK, 2, 1, 3)                                                                             \
    X(euler_both, ISO_EULER | BOTH, 1, 0, 0)                                                                           \
    X(heun_both, ISO_HEUN | BOTH, 2, 0, 0)                                                                             \
    X(rk4_both, ISO_RK4 | BOTH, 4, 0, 0)                                                                               \
    X(ab4_both, ISO_AB4 | BOTH, 1, 0, 0)                                                                               \
    X(semi_implicit_both, ISO_SEMI_IMPLICIT | BOTH, 1, 0, 0)                                                           \
    X(abm4_both, ISO_ABM4 | BOTH, 2, 0, 0)                                                                             \
    X(abm4_pec_both, ISO_ABM4_PEC | BOTH, 1, 0, 0)                                                                     \
    X(abm4_pecece_both, ISO_ABM4_PECECE | BOTH, 3, 0, 0)                                                               \
    X(bdf4_both, ISO_BDF4 | BOTH | ISO_ITERATIONS(3), 3, 1, 3)                                                         \
    X(rosenbrock_both, ISO_ROSENBROCK | BOTH, 2, 1, 4)

#define DECLARE(name, recipe, evaluations, jacobians, solutions)                                                       \
    prime_function prime_##name;                                                                                       \
    step_function step_##name;
RECIPES(DECLARE)

#endif
