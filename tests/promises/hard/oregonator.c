/* The Oregonator, a chemical oscillator: y1' = 77.27 (y2 + y1 (1 - 8.375e-6 y1 - y2)), y2' = (y3 - (1 + y1) y2) /
 * 77.27, y3' = 0.161 (y1 - y3) from (1, 2, 3): at once and every 300 s y1 bursts from 1 to 1e5 and back.
 * Field and Noyes (1974), J. Chem. Phys. 60, 1877-1884; Hairer and Wanner (1996), Solving Ordinary Differential
 * Equations II, IV.10.
 * The solution was computed at 58 digits by two methods.
 *
 * What must hold, in float and in double: bdf4 and rosenbrock have the errors stated below (the largest of a state,
 * relative) and their orders, through the first burst and, at 360 s, the second. Rounding adds 4 epsilons, and where
 * sums are not compensated half an epsilon a step; and what the numbers of the equations make, each wrong by up to
 * half an epsilon: the solution answers to a relative change of 77.27, of 8.375e-6, of 0.161 and of the step with one
 * that is larger by its condition, of the step most, since it shifts the bursts. The coefficients of a method, rounded
 * too, act as the step does. In double the conditions are computed, to a percent of those stated: half their sum, the
 * step's twice, makes 90 epsilons at 360 s. Control: a rate that is wrong by 1e-5 is found.
 * adams with a tolerance of 1e-4 reaches them all, as tests/promises/hard/tolerance.h says; its sub-steps between the
 * bursts leave 3e-5 after the second. Explicit methods at 10 ms leave the finite numbers within 3000 steps, when the
 * burst is over and y2 grows.
 */
#include <math.h>

#include "tests/promises/hard/tolerance.h"

/* That rounding adds by itself. */
#define EPSILONS 4.0

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    dx[0] = p[0] * (x[1] + x[0] * (R(1.0) - p[1] * x[0] - x[1]));
    dx[1] = (x[2] - (R(1.0) + x[0]) * x[1]) / p[0];
    dx[2] = p[2] * (x[0] - x[2]);
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)u;
    lu[0] = p[0] * (R(1.0) - R(2.0) * p[1] * x[0] - x[1]);
    lu[1] = p[0] * (R(1.0) - x[0]);
    lu[2] = R(0.0);
    lu[3] = -x[1] / p[0];
    lu[4] = -(R(1.0) + x[0]) / p[0];
    lu[5] = R(1.0) / p[0];
    lu[6] = p[2];
    lu[7] = R(0.0);
    lu[8] = -p[2];
    iso_dense_factor(lu, 3, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 3);
}

enum { TIMES = 4, NUMBERS = 3 };

static const real numbers[NUMBERS] = {R(77.27), R(8.375e-6), R(0.161)};

static const hard_problem problem = {
    "Oregonator", 3, {derivative, factor, solve, .factors = 9}, {1.0, 2.0, 3.0}, numbers};

static const double times[TIMES] = {30.0, 60.0, 120.0, 360.0};
static const long double at[TIMES][3] = {
    {1.0006614671804967182e+00L, 1.5127789373482504190e+03L, 1.0358543127672275670e+04L},
    {1.0008746251996256156e+00L, 1.1443369723844962118e+03L, 8.3721499666246241444e+01L},
    {1.0041180226126454924e+00L, 2.4383260799103455911e+02L, 1.0088222240486465401e+00L},
    {1.0008148703185227163e+00L, 1.2281785215498879837e+03L, 1.3205549428465082877e+02L},
};

/* What a relative change of a number, or of the step, makes of the states at these times: the largest relative change
 * over it. */
static const double conditions[NUMBERS + 1][TIMES] = {
    {3.08, 3.04, 1.79, 43.7},
    {1.0, 1.0, 1.0, 7.15},
    {1.46, 6.22, 1.23, 13.0},
    {4.83, 9.54, 3.11, 57.5},
};

/* The states at all times with the number `changed`, or the step if that is NUMBERS, larger by this part. */
static void solve_changed(real x[TIMES][3], const size_t changed, const double part)
{
    enum { STEPS_A_SECOND = 400 };
    static hard_run run;
    real p[NUMBERS];
    hard_problem other = problem;
    memcpy(p, numbers, sizeof p);
    other.p = p;
    p[changed % NUMBERS] *= (real)(changed < NUMBERS ? 1.0 + part : 1.0);
    hard_begin(&run, &other, ISO_BDF4 | ISO_COMPENSATED, (changed < NUMBERS ? 1.0 : 1.0 + part) / STEPS_A_SECOND);
    for (size_t i = 0; i < TIMES; i++) {
        (void)hard_go(&run, lround(STEPS_A_SECOND * (times[i] - (i > 0 ? times[i - 1] : 0.0))));
        memcpy(x[i], run.x, sizeof x[i]);
    }
}

static void test_conditions(void)
{
    static const char *const names[NUMBERS + 1] = {"77.27", "8.375e-6", "0.161", "the step"};
    const double part = 1e-7;
    real x[TIMES][3];
    real other[TIMES][3];
    solve_changed(x, 0, 0.0);
    for (size_t k = 0; k <= NUMBERS; k++) {
        solve_changed(other, k, part);
        for (size_t i = 0; i < TIMES; i++) {
            double largest = 0.0;
            for (size_t s = 0; s < problem.n; s++) {
                largest = fmax(largest, fabs((double)(other[i][s] / x[i][s]) - 1.0) / part);
            }
            report_ok(fabs(largest / conditions[k][i] - 1.0) <= 0.01,
                      "the condition of %s at %g s is %.3f, stated %.3f", names[k], times[i], largest,
                      conditions[k][i]);
        }
    }
}

static void test_wrong_rate(const hard_claim *const claim, const double rounding)
{
    const real wrong[NUMBERS] = {numbers[0], numbers[1], numbers[2] * R(1.00001)};
    hard_problem other = problem;
    other.p = wrong;
    if (hard_affords(&other, claim->recipe, claim->t, claim->n)) {
        report_ok(!hard_holds(&other, claim, rounding), "control: with a rate wrong by 1e-5 bdf4 does not");
    }
}

int main(void)
{
    static const hard_claim claims[TIMES][2] = {
        {{ISO_BDF4, 30.0, at[0], 12000, 9e-7, 4}, {ISO_ROSENBROCK, 30.0, at[0], 12000, 1.4e-6, 3}},
        {{ISO_BDF4, 60.0, at[1], 48000, 6e-8, 4}, {ISO_ROSENBROCK, 60.0, at[1], 48000, 1.6e-7, 3}},
        {{ISO_BDF4, 120.0, at[2], 96000, 1.2e-8, 4}, {ISO_ROSENBROCK, 120.0, at[2], 96000, 3.5e-8, 3}},
        {{ISO_BDF4, 360.0, at[3], 288000, 1.3e-7, 4}, {ISO_ROSENBROCK, 360.0, at[3], 288000, 3.7e-7, 3}},
    };
    if (sizeof(real) == sizeof(double)) {
        test_conditions();
    }
    double rounding = 0.0;
    for (size_t i = 0; i < TIMES; i++) {
        rounding = EPSILONS + conditions[NUMBERS][i];
        for (size_t k = 0; k < NUMBERS; k++) {
            rounding += 0.5 * conditions[k][i];
        }
        hard_expect_claims(&problem, claims[i], 2, rounding);
    }
    test_wrong_rate(&claims[TIMES - 1][0], rounding);
    static const hard_point points[TIMES] = {{30.0, at[0]}, {60.0, at[1]}, {120.0, at[2]}, {360.0, at[3]}};
    hard_expect_tolerance(&problem, points, TIMES,
                          &(hard_tolerance){.tolerance = 1e-4, .tick = 0.1, .decays = 1.1267e7, .rounding = rounding});
    hard_expect_explicit_failures(&problem, 0.01, 3000);
    return report_done();
}
