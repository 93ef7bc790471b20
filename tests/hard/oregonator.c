/* The Oregonator, a chemical oscillator: y1' = 77.27 (y2 + y1 (1 - 8.375e-6 y1 - y2)), y2' = (y3 - (1 + y1) y2) /
 * 77.27, y3' = 0.161 (y1 - y3) from (1, 2, 3): at once and every 300 s y1 bursts from 1 to 1e5 and back.
 * Field and Noyes (1974), J. Chem. Phys. 60, 1877-1884; Hairer and Wanner (1996), Solving Ordinary Differential
 * Equations II, IV.10.
 * The solution was computed at 58 digits by two methods.
 *
 * What must hold, in float and in double: through the burst bdf4 and rosenbrock have the errors stated below (the
 * largest of a state, relative) and their orders. In float rounding adds 20 epsilons, and where sums are not
 * compensated half an epsilon a step. After the second burst, at 360 s, the same in double alone.
 * Explicit methods at 10 ms leave the finite numbers within 3000 steps, when the burst is over and y2 grows.
 */
#include "tests/hard/hard.h"

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[0] = R(77.27) * (x[1] + x[0] * (R(1.0) - R(8.375e-6) * x[0] - x[1]));
    dx[1] = (x[2] - (R(1.0) + x[0]) * x[1]) / R(77.27);
    dx[2] = R(0.161) * (x[0] - x[2]);
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)u;
    (void)p;
    lu[0] = R(77.27) * (R(1.0) - R(2.0) * R(8.375e-6) * x[0] - x[1]);
    lu[1] = R(77.27) * (R(1.0) - x[0]);
    lu[2] = R(0.0);
    lu[3] = -x[1] / R(77.27);
    lu[4] = -(R(1.0) + x[0]) / R(77.27);
    lu[5] = R(1.0) / R(77.27);
    lu[6] = R(0.161);
    lu[7] = R(0.0);
    lu[8] = R(-0.161);
    iso_dense_factor(lu, 3, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 3);
}

static const long double at[3][3] = {
    {1.0006614671804967182e+00L, 1.5127789373482504190e+03L, 1.0358543127672275670e+04L},
    {1.0008746251996256156e+00L, 1.1443369723844962118e+03L, 8.3721499666246241444e+01L},
    {1.0008148703185227163e+00L, 1.2281785215498879837e+03L, 1.3205549428465082877e+02L},
};

static const hard_problem problem = {"Oregonator", 3, {derivative, factor, solve, .factors = 9}, {1.0, 2.0, 3.0}, NULL};

int main(void)
{
    static const hard_claim claims[] = {
        {ISO_BDF4, 30.0, at[0], 12000, 9e-7, 4},     {ISO_ROSENBROCK, 30.0, at[0], 12000, 1.4e-6, 3},
        {ISO_BDF4, 60.0, at[1], 48000, 6e-8, 4},     {ISO_ROSENBROCK, 60.0, at[1], 48000, 1.6e-7, 3},
        {ISO_BDF4, 360.0, at[2], 288000, 1.3e-7, 4}, {ISO_ROSENBROCK, 360.0, at[2], 288000, 3.7e-7, 3},
    };
    hard_expect_claims(&problem, claims, HARD_PICK(4, sizeof claims / sizeof *claims), 20.0);
    hard_expect_explicit_failures(&problem, 0.01, 3000);
    return report_done();
}
