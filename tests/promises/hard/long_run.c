/* A million steps of 1 ms, a thousand seconds, without damping: what becomes of the energy, in float and in double.
 *
 * Three plants: a pendulum, whose acceleration comes from a potential alone; a double pendulum, which swings by 60 and
 * 30 degrees or falls from both rods horizontal (chaotic, so that only the energy can be asked for); a chain of ten
 * links of 0.1 m, which swings by 17 degrees or, for 200 s, falls from the horizontal like a whip. On the chain the
 * implicit methods run for 50 s and 20 s.
 *
 * What must hold: the energy E, zero where the plant hangs at rest, never leaves E(0) (1 +- bound), sampled every 50
 * steps. The bound of a method is the table below and holds in double; in float rounding adds `rounding` epsilons times
 * the square root of the number of steps, as a random walk, and 25 times `rounding` epsilons where sums are
 * compensated.
 *   rk4 loses energy, a little: |R(i z)|^2 = 1 - z^6 / 72.
 *   semi_implicit swings about E(0) on the pendulum, where it is symplectic. It is not on the others, whose
 *   accelerations depend on the speeds: there it drifts like a method of order one.
 *   rosenbrock on the falling rods: its own error depends on the path, which rounding changes. Of three starts within
 *   5e-4 rad one lost 5e-3 in float, in one violent turn, the others 4e-4 and 9e-4; the bound is of the first.
 *   euler gains energy, the negative control: it ends beyond twice E(0), or with states that are not finite.
 */
#include <math.h>

#include "tests/promises/hard/chain.h"

enum { SAMPLE = 50 };

#define MILLION 1000000L

typedef struct long_case {
    hard_problem problem;
    long steps, implicit_steps;
    double rounding;
    double bound[ISO_METHODS];
} long_case;

static const real one[] = {R(9.81), R(1.0), R(1.0)};
static const real two[] = {R(9.81), R(1.0), R(1.0), R(1.0)};
static const real ten[] = {R(9.81), R(0.1), R(1.0), R(1.0), R(1.0), R(1.0),
                           R(1.0),  R(1.0), R(1.0), R(1.0), R(1.0), R(1.0)};

#define BOUNDS(heun, rk4, ab4, semi, abm4, bdf4, ros)                                                                  \
    {                                                                                                                  \
        [ISO_HEUN] = (heun), [ISO_RK4] = (rk4), [ISO_AB4] = (ab4), [ISO_SEMI_IMPLICIT] = (semi), [ISO_ABM4] = (abm4),  \
        [ISO_BDF4] = (bdf4), [ISO_ROSENBROCK] = (ros)                                                                  \
    }

static const long_case cases[] = {
    {{"pendulum", 2, {.derivative = NULL}, {1.0}, one},
     MILLION,
     MILLION,
     2.0,
     BOUNDS(4e-5, 2e-11, 2e-9, 3e-3, 5e-10, 1.2e-9, 1e-5)},
    {{"double pendulum", 4, {.derivative = NULL}, {1.0, 0.5}, two},
     MILLION,
     MILLION,
     2.0,
     BOUNDS(7e-5, 3e-10, 3e-8, 2.2, 6e-9, 2e-8, 2e-5)},
    {{"double pendulum, falling", 4, {.derivative = NULL}, {1.57079632679489661923, 1.57079632679489661923}, two},
     MILLION,
     MILLION,
     30.0,
     BOUNDS(2e-4, 6e-8, 4e-6, 1.0, 4e-7, 3e-6, 2e-3)},
    {{"chain", 20, {.derivative = NULL}, {0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3}, ten},
     MILLION,
     MILLION / 20,
     2.0,
     BOUNDS(1.5e-3, 5e-8, 4e-6, 0.6, 1.2e-6, 1.3e-7, 1.2e-5)},
    {{"chain, falling", 20, {.derivative = NULL}, {1.57, 1.57, 1.57, 1.57, 1.57, 1.57, 1.57, 1.57, 1.57, 1.57}, ten},
     MILLION / 5,
     MILLION / 50,
     30.0,
     BOUNDS(0.1, 6e-3, 0.1, 2.0, 0.02, 0.01, 0.03)},
};

/* Returns the largest |E / E(0) - 1|, infinite when a state is not finite; *end is E / E(0) - 1 at the end. */
static double drift_of(const hard_problem *const problem, const unsigned recipe, const long steps, double *const end)
{
    static hard_run run;
    hard_begin(&run, problem, recipe, 1e-3);
    const double start = chain_energy(&run);
    double largest = 0.0;
    *end = 0.0;
    for (long i = 0; i < steps && hard_guard(&run) == problem->n; i += SAMPLE) {
        (void)hard_go(&run, SAMPLE);
        *end = chain_energy(&run) / start - 1.0;
        largest = fmax(largest, fabs(*end));
    }
    return hard_guard(&run) < problem->n ? (double)INFINITY : largest;
}

static void test_method(const long_case *const c, const unsigned recipe)
{
    const bool implicit = ISO_IS_IMPLICIT(recipe);
    const bool compensated = ISO_IS_COMPENSATED(recipe);
    const long steps = implicit ? c->implicit_steps : c->steps;
    const double walk = c->rounding * (compensated ? 25.0 : sqrt((double)steps));
    const double bound = c->bound[ISO_METHOD_OF(recipe)] + walk * (double)ISO_REAL_EPSILON;
    double end = 0.0;
    const double drift = drift_of(&c->problem, recipe, steps, &end);
    report_ok(drift <= bound, "%s, %s%s, %ld steps: energy to %.2e (bound %.1e), at the end %+.2e", c->problem.name,
              hard_name(recipe), compensated ? ", compensated" : "", steps, drift, bound, end);
    if (recipe == ISO_SEMI_IMPLICIT && c->problem.n == 4) {
        report_ok(drift > 0.1, "%s, semi_implicit: not symplectic, as said", c->problem.name);
    }
    if (ISO_IS(recipe, ISO_RK4) && sizeof(real) == sizeof(double)) {
        report_ok(end < 0.0, "%s, rk4: it loses energy", c->problem.name);
    }
}

int main(void)
{
    static const unsigned methods[] = {ISO_HEUN, ISO_RK4,  ISO_AB4,       ISO_SEMI_IMPLICIT,
                                       ISO_ABM4, ISO_BDF4, ISO_ROSENBROCK};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        long_case c = cases[i];
        c.problem.equations = c.problem.n == 2 ? chain_of_1 : (c.problem.n == 4 ? chain_of_2 : chain_of_10);
        for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
            test_method(&c, methods[m]);
            if (sizeof(real) < sizeof(double) && c.problem.n == 4 && i == 1) {
                test_method(&c, methods[m] | ISO_COMPENSATED);
            }
        }
        double end = 0.0;
        const double drift = drift_of(&c.problem, ISO_EULER, c.steps, &end);
        report_ok(drift > 1.0, "control: %s, euler: energy to %.1e", c.problem.name, drift);
    }
    return report_done();
}
