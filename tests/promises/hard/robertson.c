/* Robertson's reaction: y1' = -0.04 y1 + 1e4 y2 y3, y2' = 0.04 y1 - 1e4 y2 y3 - 3e7 y2^2, y3' = 3e7 y2^2 from (1, 0,
 * 0). y2 settles in the first milliseconds and then follows the others with time constants down to 0.1 ms, for ever.
 * Robertson (1966), in Walsh (ed.), Numerical Analysis: an Introduction; Mazzia and Magherini (2008), Test Set for IVP
 * Solvers, ROBER.
 * The solution was computed at 58 digits by two methods.
 *
 * What must hold, in float and in double: bdf4 and rosenbrock have the errors stated below (the largest of a state,
 * relative).
 *   over all of it: with steps of 0.08 and 0.16 ms, which resolve the first milliseconds, their orders too; with steps
 * of 1 ms nine digits after 40 s and eleven after 4000 s. In float rounding adds 4 epsilons, and where sums are not
 *   compensated half an epsilon a step: 7 digits after four million steps with compensation, 3 without.
 *   from the solution at 40 s on, with steps that grow from 0.4 s to 1e7 s, every later time of the test set. Rounding
 *   adds to bdf4 4 epsilons; to rosenbrock that of a derivative, three halves of an epsilon, times the sum of its
 * weights, 7.6, makes 12; and 0.04 gamma h, since the second pivot of 1 - gamma h J is a difference of numbers larger
 * by that: it shows at 1e11 s. Bdf4 has such pivots too, but solves with them only for what its predictor leaves. adams
 * with a tolerance of 1e-8 up to 4000 s, in float to 40 s, as tests/promises/hard/tolerance.h says. The square is that
 * of y2, whose swing makes y3 grow: after 4000 s it rules. Explicit methods at 10 ms leave the finite numbers within 40
 * steps.
 */
#include "tests/promises/hard/tolerance.h"

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    const real slow = R(0.04) * x[0];
    const real back = R(1e4) * x[1] * x[2];
    const real fast = R(3e7) * x[1] * x[1];
    dx[0] = back - slow;
    dx[1] = slow - back - fast;
    dx[2] = fast;
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)u;
    (void)p;
    const real by_third = R(1e4) * x[1];
    const real by_second = R(1e4) * x[2];
    const real fast = R(6e7) * x[1];
    lu[0] = R(-0.04);
    lu[1] = by_second;
    lu[2] = by_third;
    lu[3] = R(0.04);
    lu[4] = -by_second - fast;
    lu[5] = -by_third;
    lu[6] = R(0.0);
    lu[7] = fast;
    lu[8] = R(0.0);
    iso_dense_factor(lu, 3, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 3);
}

enum { TIMES = 6, LATER = 4 };

/* At 0.4, 40, 4e3, 1e5, 1e7 and 1e11 s. */
static const long double at[TIMES][3] = {
    {9.8517211386098986242e-01L, 3.3863953789749041364e-05L, 1.4794022185220388544e-02L},
    {7.158270687194050905e-01L, 9.185534764557763904e-06L, 2.841637457458303518e-01L},
    {1.8320225777670931130e-01L, 8.9423712527759092599e-07L, 8.1679684798616541111e-01L},
    {1.7865921142099464965e-02L, 7.2747514684363187708e-08L, 9.8213400611038585067e-01L},
    {2.0760934390163957190e-04L, 8.3060774850676126281e-10L, 9.9979238982549061192e-01L},
    {2.0833401497012942306e-08L, 8.3333607703347834006e-14L, 9.9999997916651516938e-01L},
};

static const hard_problem problem = {"Robertson", 3, {derivative, factor, solve, .factors = 9}, {1.0, 0.0, 0.0}, NULL};

#define EPSILONS 4.0
#define ROSENBROCK_EPSILONS 12.0

/* From one time of the test set to the next. */
static void test_later(void)
{
    static const char *const names[LATER] = {"Robertson from 40 s", "Robertson from 4e3 s", "Robertson from 1e5 s",
                                             "Robertson from 1e7 s"};
    static const hard_claim claims[LATER][2] = {
        {{ISO_BDF4, 3960.0, at[2], 10000, 6e-11, 4}, {ISO_ROSENBROCK, 3960.0, at[2], 10000, 1.2e-10, 3}},
        {{ISO_BDF4, 9.6e4, at[3], 2500, 7e-10, 4}, {ISO_ROSENBROCK, 9.6e4, at[3], 2500, 1e-9, 3}},
        {{ISO_BDF4, 9.9e6, at[4], 5000, 7e-9, 4}, {ISO_ROSENBROCK, 9.9e6, at[4], 5000, 4.2e-9, 3}},
        {{ISO_BDF4, 9.999e10, at[5], 40000, 6.5e-8, 0}, {ISO_ROSENBROCK, 9.999e10, at[5], 10000, 5.9e-6, 3}},
    };
    for (size_t i = 0; i < LATER; i++) {
        const hard_claim *const rosenbrock = &claims[i][1];
        const double gamma_h = (double)iso_table_ros3.gamma * rosenbrock->t / (double)rosenbrock->n;
        hard_problem later = problem;
        later.name = names[i];
        for (size_t s = 0; s < later.n; s++) {
            later.start[s] = (double)at[i + 1][s];
        }
        hard_expect_claims(&later, &claims[i][0], 1, EPSILONS);
        hard_expect_claims(&later, rosenbrock, 1, ROSENBROCK_EPSILONS + 0.04 * gamma_h);
    }
}

int main(void)
{
    static const hard_claim claims[] = {
        {ISO_BDF4, 40.0, at[1], 40000, 7.5e-10, 0},     {ISO_ROSENBROCK, 40.0, at[1], 40000, 2e-10, 0},
        {ISO_BDF4, 4000.0, at[2], 4000000, 1.1e-11, 0}, {ISO_ROSENBROCK, 4000.0, at[2], 4000000, 4e-12, 0},
        {ISO_BDF4, 0.4, at[0], 5120, 1e-11, 4},         {ISO_ROSENBROCK, 0.4, at[0], 2560, 2e-11, 3},
    };
    static const hard_point points[] = {{0.4, at[0]}, {40.0, at[1]}, {4000.0, at[2]}};
    hard_expect_claims(&problem, claims, sizeof claims / sizeof *claims, EPSILONS);
    test_later();
    hard_expect_tolerance(&problem, points, HARD_PICK(2, 3),
                          &(hard_tolerance){.tolerance = 1e-8,
                                            .tick = 0.1,
                                            .decays = HARD_PICK(1.143e5, 2.8685e7),
                                            .squared = 3e7,
                                            .rounding = EPSILONS});
    hard_expect_explicit_failures(&problem, 0.01, 40);
    return report_done();
}
