/* A quarter car: a body on its spring, a wheel on a bushing of 2e8 N/m, a thousand times as stiff as a tyre. Linear:
 *
 *     ms zs'' = -ks (zs - zu) - cs (zs' - zu'),   mu zu'' = ks (zs - zu) + cs (zs' - zu') - kt zu - ct zu'
 *
 * ms = 320 kg, mu = 45 kg, ks = 22 kN/m, cs = 1500 Ns/m, kt = 2e8 N/m, ct = 2e5 Ns/m, from zs = 50 mm, zu = 10 mm at
 * rest. Its eigenvalues are -2992.44, -1485.33 and the body's -2.3433 +- 7.9532 i, 73.58 degrees off the negative real
 * axis. The solution is that of the matrix exponential at 90 digits.
 *
 * What must hold, in float and in double:
 *   at 1 kHz, over both fast modes, bdf4 has an error of 5.5e-9 at 0.5 s and 2^-4 of it at half the step, rosenbrock
 *   1.4e-7 and 2^-3 (the largest of any state, relative), and in float 400 epsilons, which zu and zu' lose: their
 *   derivatives are differences of forces 2e4 times as large. Steps of 16 us resolve the fast modes, at 1 and at 10 ms.
 *   adams with a tolerance of 1e-6 reaches the solution at all times, as tests/promises/hard/tolerance.h says.
 *   bdf4 is A(73.35 degrees)-stable, no more: in the band 0.206 s < h < 0.256 s the body's mode grows, by the largest
 *   root of the formula's characteristic polynomial, to 1e-9 (5e-8 in float); beside the band it decays as that root
 *   says. rosenbrock, L-stable, decays in the band.
 *   explicit methods: 1 % below their limit on the real axis the fastest mode dies away, 1 % above it the run ends with
 *   states that are not finite. At 1 kHz none of them runs.
 */
#include <math.h>

#include "tests/promises/hard/tolerance.h"

enum { ZS, ZU, VS, VU, STATES };

/* That rounding adds. */
#define EPSILONS 400.0

#define FASTEST 2992.44385511704
#define BODY_RE (-2.34331737683944)
#define BODY_IM 7.95321687168653

/* The speeds' rows of the Jacobian, times the masses. */
static const real force[2][STATES] = {
    {R(-22000.0), R(22000.0), R(-1500.0), R(1500.0)},
    {R(22000.0), R(-200022000.0), R(1500.0), R(-201500.0)},
};
static const real mass[2] = {R(320.0), R(45.0)};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[ZS] = x[VS];
    dx[ZU] = x[VU];
    const real spring = R(22000.0) * (x[ZS] - x[ZU]) + R(1500.0) * (x[VS] - x[VU]);
    dx[VS] = -spring / mass[0];
    dx[VU] = (spring - (R(2e8) * x[ZU] + R(2e5) * x[VU])) / mass[1];
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    (void)p;
    for (size_t i = 0; i < 2; i++) {
        for (size_t j = 0; j < STATES; j++) {
            lu[i * STATES + j] = j == i + 2 ? R(1.0) : R(0.0);
            lu[(i + 2) * STATES + j] = force[i][j] / mass[i];
        }
    }
    iso_dense_factor(lu, STATES, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, STATES);
}

static const long double at_thousandth[STATES] = {0.0499855289019411032144268897722L,
                                                  0.00400450289515263529080102423395L,
                                                  -0.03097728756897390546901473131L, -5.19566832070458449745618247475L};
static const long double at_hundredth[STATES] = {
    0.0494250202069885987995505865245L, 0.00000489209751889823475466732181426L, -0.0776699942238986477512650842103L,
    -0.0000415435216477287499002111859716L};
static const long double at_tenth[STATES] = {0.032752612597383934815249306346L, 0.00000167189624191076579584719493862L,
                                             -0.262339358905484441680612351639L, -0.000036576343305895970898662224327L};
static const long double at_half[STATES] = {-0.0124555228518904710933196492562L,
                                            -0.000000590496566211379724795763892711L, 0.105869275885815337690803128944L,
                                            0.0000143718091182539471789253954992L};
static const long double at_two[STATES] = {-0.000468460287026972044069868827643L,
                                           -0.0000000430037332816053997222116308932L,
                                           0.0011804508400801001117915878677L, 0.000000328431349641969232120230626433L};

static const hard_problem problem = {
    "quarter car", STATES, {derivative, factor, solve, .factors = 16}, {0.05, 0.01, 0.0, 0.0}, NULL};

/* The growth per step of the slowest pair of modes, seen after all others died away: for z_n = Re(c r^n) the number
 * z_n^2 - z_(n-1) z_(n+1) is |c r^n Im(r)|^2 / |r|^2, so that two of them SPAN steps apart give |r|. */
static double observed_growth(const unsigned recipe, const double h)
{
    enum { SETTLE = 300, SPAN = 2000 };
    static hard_run run;
    double product[2] = {0.0, 0.0};
    hard_begin(&run, &problem, recipe, h);
    for (int i = 0; i < 2; i++) {
        double z[3];
        (void)hard_go(&run, i == 0 ? SETTLE : SPAN - 2);
        for (int j = 0; j < 3; j++) {
            z[j] = (double)run.x[ZS];
            (void)hard_go(&run, j < 2 ? 1 : 0);
        }
        product[i] = z[1] * z[1] - z[0] * z[2];
    }
    return pow(product[1] / product[0], 0.5 / SPAN);
}

/* Inside the band and beside it bdf4 does what its characteristic polynomial says, and rosenbrock decays. */
static void test_wedge(void)
{
    static const double steps[] = {0.19, 0.20, 0.21, 0.23, 0.25, 0.26, 0.27};
    enum { TICKS = 300 };
    static hard_run run;
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        const double h = (double)(real)steps[i];
        const double theory = hard_bdf4_growth(h * BODY_RE, h * BODY_IM);
        const double seen = observed_growth(ISO_BDF4, h);
        const bool in_band = h > 0.206 && h < 0.256;
        report_ok(fabs(seen - theory) <= HARD_PICK(5e-8, 1e-9) && (theory > 1.0) == in_band,
                  "bdf4 with h = %g s: %.9f a step, by its characteristic polynomial %.9f: it %s", steps[i], seen,
                  theory, in_band ? "grows" : "decays");
        hard_begin(&run, &problem, ISO_ROSENBROCK, h);
        const long taken = hard_go(&run, TICKS);
        report_ok(taken == TICKS && fabs((double)run.x[ZS]) < 1e-20, "rosenbrock with h = %g s decays to %.1e",
                  steps[i], fabs((double)run.x[ZS]));
    }
}

/* 1 % to either side of a method's limit on the negative real axis. */
static void test_limits(void)
{
    static const struct {
        unsigned method;
        double limit;
    } cases[] = {{ISO_EULER, 2.0}, {ISO_HEUN, 2.0}, {ISO_RK4, 2.785293563405282}, {ISO_AB4, 0.3}};
    static hard_run run;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double h = 0.99 * cases[i].limit / FASTEST;
        const long steps = lround(5.0 / h);
        hard_begin(&run, &problem, cases[i].method, h);
        const bool finite = hard_go(&run, steps) == steps;
        report_ok(finite && fabs((double)run.x[VU]) < 1e-6,
                  "%s 1 %% below its limit, h = %.3e s: after 5 s zu' is %.1e", hard_name(cases[i].method), h,
                  fabs((double)run.x[VU]));
        hard_expect_failure(&problem, cases[i].method, 1.01 / 0.99 * h, 200000);
    }
}

int main(void)
{
    static const hard_claim claims[] = {
        {ISO_BDF4, 0.5, at_half, 500, 5.5e-9, 4},        {ISO_ROSENBROCK, 0.5, at_half, 500, 1.4e-7, 3},
        {ISO_BDF4, 0.1, at_tenth, 100, 1.4e-9, 4},       {ISO_ROSENBROCK, 0.1, at_tenth, 100, 2.4e-8, 3},
        {ISO_BDF4, 2.0, at_two, 2000, 1.8e-8, 4},        {ISO_ROSENBROCK, 2.0, at_two, 2000, 8.1e-7, 3},
        {ISO_BDF4, 0.001, at_thousandth, 64, 6.9e-7, 4}, {ISO_ROSENBROCK, 0.001, at_thousandth, 64, 1.6e-6, 3},
        {ISO_BDF4, 0.01, at_hundredth, 640, 2.3e-7, 4},  {ISO_ROSENBROCK, 0.01, at_hundredth, 640, 1.2e-6, 3},
    };
    hard_expect_claims(&problem, claims, sizeof claims / sizeof *claims, EPSILONS);
    static const hard_point points[] = {
        {0.001, at_thousandth}, {0.01, at_hundredth}, {0.1, at_tenth}, {0.5, at_half}, {2.0, at_two}};
    hard_expect_tolerance(
        &problem, points, sizeof points / sizeof *points,
        &(hard_tolerance){.tolerance = 1e-6, .tick = 0.001, .decays = 2.0 * FASTEST, .rounding = EPSILONS});
    test_wedge();
    test_limits();
    for (unsigned method = ISO_EULER; method <= ISO_ABM4_PECECE; method++) {
        hard_expect_failure(&problem, method, 1e-3, 2500);
    }
    return report_done();
}
