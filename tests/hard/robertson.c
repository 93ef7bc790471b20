/* Robertson's reaction: y1' = -0.04 y1 + 1e4 y2 y3, y2' = 0.04 y1 - 1e4 y2 y3 - 3e7 y2^2, y3' = 3e7 y2^2 from (1, 0,
 * 0). y2 settles in the first milliseconds and then follows the others with time constants down to 0.1 ms, for ever.
 * Robertson (1966), in Walsh (ed.), Numerical Analysis: an Introduction; Mazzia and Magherini (2008), Test Set for IVP
 * Solvers, ROBER.
 * The solution was computed at 58 digits by two methods.
 *
 * What must hold, in float and in double: bdf4 and rosenbrock have the errors stated below (the largest of a state,
 * relative), and their orders where steps of 0.08 and 0.16 ms resolve the first milliseconds. Steps of 1 ms, over all of it,
 * end after 40 s with 9 digits, rosenbrock's after 4000 s with 11. In float rounding adds 4 epsilons, and where sums
 * are not compensated half an epsilon a step: 7 digits after four million steps with compensation, 3 without.
 * Explicit methods at 10 ms leave the finite numbers within 40 steps.
 */
#include "tests/hard/hard.h"

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

static const long double at[3][3] = {
    {9.8517211386098986242e-01L, 3.3863953789749041364e-05L, 1.4794022185220388544e-02L},
    {7.158270687194050905e-01L, 9.185534764557763904e-06L, 2.841637457458303518e-01L},
    {1.8320225777670931130e-01L, 8.9423712527759092599e-07L, 8.1679684798616541111e-01L},
};

static const hard_problem problem = {"Robertson", 3, {derivative, factor, solve, .factors = 9}, {1.0, 0.0, 0.0}, NULL};

int main(void)
{
    static const hard_claim claims[] = {
        {ISO_BDF4, 0.4, at[0], 5120, 1e-11, 4},
        {ISO_ROSENBROCK, 0.4, at[0], 2560, 2e-11, 3},
        {ISO_BDF4, 40.0, at[1], 40000, 7.5e-10, 0},
        {ISO_ROSENBROCK, 40.0, at[1], 40000, 2e-10, 0},
        {ISO_ROSENBROCK, 4000.0, at[2], 4000000, 4e-12, 0},
    };
    hard_expect_claims(&problem, claims, sizeof claims / sizeof *claims, 4.0);
    hard_expect_explicit_failures(&problem, 0.01, 40);
    return report_done();
}
