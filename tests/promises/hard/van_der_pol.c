/* Van der Pol's oscillator, mu = 1000, in slow time: y1' = y2, y2' = ((1 - y1^2) y2 - y1) / 1e-6 from (2, 0). After a
 * layer of 0.3 us the solution creeps for 0.807 s, jumps to the other side within microseconds, and creeps again.
 * Hairer and Wanner (1996), Solving Ordinary Differential Equations II, IV.10; Mazzia and Magherini (2008), Test Set
 * for IVP Solvers, VDPOL. The solution was computed at 58 digits by two methods.
 *
 * What must hold, in float and in double (errors are the largest of a state, relative):
 *   stepping over the first layer, which is not resolved, at 0.5 s with h = 1/128 s: bdf4, whose history is that of
 *   the solution beyond it, 7e-8 and order four; rosenbrock 3.1e-5 and order two.
 *   started beyond the layer, from the solution at 0.25 s: bdf4 is of order four (3.4e-9 with h = 1/256 s), rosenbrock
 *   of order two, which is ROS3's on a plant so stiff that it is nearly algebraic (Hairer and Wanner, VI.3).
 *   across the jump with h = 0.4 us: 1.2e-2 and 2.5e-3 at 1 s. In float only with compensation: h y2 is less than an
 *   ulp of y1. Across the second one too, with h = 0.2 us: 7.1e-4 and 7.8e-4 at 2 s, 2.93 times what this step leaves
 * at 1 s, since every jump is late by the same time. adams with a tolerance of 1e-6 reaches 0.5, 1 and 2 s, as
 * tests/promises/hard/tolerance.h says. The decays: along the slow branch from 2 to 1 dt = -(y1^2 - 1) / y1 dy1 and
 * lambda = (y1^2 - 1) / 1e-6, which makes 3/4 + log 2 = 1.443 millions in 0.807 s. rosenbrock at 100 us cannot follow
 * the jump, ends up anywhere on the slow branch, and its local error says so: 1e5 and more, against 1e-4 before. bdf4
 * leaves the finite numbers at the jump. explicit methods at 1 ms leave them within 20 steps. semi_implicit just above
 * its limit, at 0.74 us, is the one that does not: it chatters about a solution that is wrong by 70 % at 0.5 s, and its
 * local error says so. In float rounding adds 40 epsilons, and where sums are not compensated half an epsilon a step.
 */
#include <math.h>

#include "tests/promises/hard/tolerance.h"

#define EPSILON R(1e-6)

/* That rounding adds. */
#define EPSILONS 40.0

/* The solution at 0.25 s: two methods, each at two steps of 1e-7 s and less, agree to 15 digits. */
#define START 1.8195982936829986, -0.78738490481402135

/* Steps after which the check of a step compares with derivatives that were taken. */
enum { SETTLED = 10 };

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = ((R(1.0) - x[0] * x[0]) * x[1] - x[0]) / EPSILON;
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)u;
    (void)p;
    lu[0] = R(0.0);
    lu[1] = R(1.0);
    lu[2] = (R(-2.0) * x[0] * x[1] - R(1.0)) / EPSILON;
    lu[3] = (R(1.0) - x[0] * x[0]) / EPSILON;
    iso_dense_factor(lu, 2, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 2);
}

static const long double at_half[2] = {1.5967689510526617598e+00L, -1.0303911878393566657e+00L};
static const long double at_one[2] = {-1.8636462548081338895e+00L, 7.5354308654354336010e-01L};
static const long double at_two[2] = {1.7061677321704650085e+00L, -8.9280970102481654778e-01L};

static const hard_problem problem = {"Van der Pol", 2, {derivative, factor, solve, .factors = 4}, {2.0, 0.0}, NULL};
static const hard_problem beyond_layer = {
    "Van der Pol beyond its first layer", 2, {derivative, factor, solve, .factors = 4}, {START}, NULL};

/* The errors at 1 s and at 2 s, after one and two jumps, with so many steps a second. */
static void pass_two_jumps(double error[2], const unsigned method, const long steps)
{
    static hard_run run;
    hard_begin(&run, &problem, method | ISO_COMPENSATED, 1.0 / (double)steps);
    (void)hard_go(&run, steps);
    error[0] = hard_error(&run, at_one);
    (void)hard_go(&run, steps);
    error[1] = hard_error(&run, at_two);
}

/* d(log y2) / dt on the slow branch, where y2 = y1 / (1 - y1^2). */
static double slow_rate(const long double y[2])
{
    return (double)(y[1] / y[0] * (1.0L + y[0] * y[0]) / (1.0L - y[0] * y[0]));
}

/* What squares of the delays, which are below 1e-3 s, make of the ratio. */
#define RATIO_TOLERANCE 5e-3

static void test_two_jumps(const unsigned method, const double most)
{
    enum { STEPS = 5000000 };
    if (!hard_affords(&problem, method, 2.0, 2L * STEPS)) {
        return;
    }
    const double expected = 2.0 * fabs(slow_rate(at_two) / slow_rate(at_one));
    double error[2];
    pass_two_jumps(error, method, STEPS);
    report_ok(error[1] <= most && fabs(error[1] / error[0] / expected - 1.0) <= RATIO_TOLERANCE,
              "%s with h = 0.2 us: error %.2e at 2 s, %.3f times that at 1 s, as twice the delay makes it: %.3f",
              hard_name(method), error[1], error[1] / error[0], expected);
    pass_two_jumps(error, method, STEPS / 2);
    report_ok(error[1] > most, "control: with h = 0.4 us the error is %.2e", error[1]);
}

/* The largest local error that the method tells of on the way to t. */
static double told(const unsigned recipe, const double t, const double h)
{
    static hard_run run;
    double largest = 0.0;
    hard_begin(&run, &problem, recipe | ISO_CHECKED, h);
    for (long i = 0; i < lround(t / h); i++) {
        (void)hard_go(&run, 1);
        largest = fmax(largest, i < SETTLED ? 0.0 : (double)run.progress.progress.local_error);
    }
    return largest;
}

int main(void)
{
    static const hard_claim early[] = {
        {ISO_BDF4, 1.0, at_one, 2500000, 1.2e-2, 0},
        {ISO_ROSENBROCK, 1.0, at_one, 2500000, 2.5e-3, 0},
        {ISO_BDF4, 0.5, at_half, 64, 7e-8, 4},
        {ISO_ROSENBROCK, 0.5, at_half, 64, 3.1e-5, 2},
    };
    static const hard_claim late[] = {
        {ISO_BDF4, 0.25, at_half, 64, 3.4e-9, 4},
        {ISO_ROSENBROCK, 0.25, at_half, 128, 8e-7, 2},
    };
    hard_expect_claims(&problem, early, sizeof early / sizeof *early, EPSILONS);
    hard_expect_claims(&beyond_layer, late, sizeof late / sizeof *late, EPSILONS);
    test_two_jumps(ISO_BDF4, 7.1e-4);
    test_two_jumps(ISO_ROSENBROCK, 7.8e-4);
    static const hard_point points[] = {{0.5, at_half}, {1.0, at_one}, {2.0, at_two}};
    hard_expect_tolerance(
        &problem, points, sizeof points / sizeof *points,
        &(hard_tolerance){.tolerance = 1e-6, .tick = 0.01, .decays = 1.443e6 * 2.0 / 0.807, .rounding = EPSILONS});

    const double smooth = told(ISO_ROSENBROCK, 0.8, 1e-4);
    const double jump = told(ISO_ROSENBROCK, 0.9, 1e-4);
    report_ok(smooth < 1e-3 && jump > 1.0,
              "rosenbrock at h = 1e-4 s tells of an error of %.1e before the jump, of %.1e there", smooth, jump);
    const double within = told(ISO_SEMI_IMPLICIT, 0.1, 5e-7);
    const double beyond = told(ISO_SEMI_IMPLICIT, 0.1, 7.4e-7);
    report_ok(beyond > 1e3 * within, "semi_implicit tells of an error of %.1e with h = 0.5 us, of %.1e with 0.74 us",
              within, beyond);
    static hard_run run;
    hard_begin(&run, &problem, ISO_SEMI_IMPLICIT, 7.4e-7);
    (void)hard_go(&run, lround(0.5 / 7.4e-7));
    report_ok(hard_guard(&run) == problem.n && hard_error(&run, at_half) > 0.1,
              "with 0.74 us it is finite and wrong: error %.2f", hard_error(&run, at_half));
    hard_expect_failure(&problem, ISO_BDF4, 1e-4, 10000);
    for (unsigned method = ISO_EULER; method <= ISO_ABM4_PECECE; method++) {
        hard_expect_failure(&problem, method, 1e-3, 20);
    }
    return report_done();
}
