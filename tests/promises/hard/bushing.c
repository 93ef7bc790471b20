/* A body of 1 kg on a bushing of 1e8 N/m at 1 kHz, without damping and with a hundredth of the critical: it swings at
 * 1e4 rad/s, ten radians a step, which no step at 1 kHz resolves. A force of 1e5 N that sets in at the start moves it
 * by 1 mm in the mean.
 *
 * What must hold, in float and in double:
 *   bdf4 and rosenbrock take the vibration out, the undamped too, since their growth at z = 10 i is below 1, and stand
 *   at F / k after 1 s to 4 ulp. Their growth per step is what theory says: that of the undamped body's energy per step
 *   |R(10 i)|^2 for rosenbrock, the largest root of its characteristic polynomial for bdf4.
 *   all explicit methods end with states that are not finite.
 */
#include <complex.h>
#include <math.h>

#include "tests/promises/hard/hard.h"

enum { POSITION, SPEED, STATES };

#define MASS R(1.0)
#define STIFFNESS R(1e8)
#define FORCE R(1e5)
#define STEP 0.001

static const real undamped[1] = {R(0.0)};
static const real damped[1] = {R(200.0)};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    dx[POSITION] = x[SPEED];
    dx[SPEED] = (u[0] - STIFFNESS * x[POSITION] - p[0] * x[SPEED]) / MASS;
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    lu[0] = R(0.0);
    lu[1] = R(1.0);
    lu[2] = -STIFFNESS / MASS;
    lu[3] = -p[0] / MASS;
    iso_dense_factor(lu, STATES, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, STATES);
}

static const hard_problem problems[] = {
    {"bushing without damping", STATES, {derivative, factor, solve, .factors = 4}, {0.0, 0.0}, undamped},
    {"bushing with damping", STATES, {derivative, factor, solve, .factors = 4}, {0.0, 0.0}, damped},
};

/* Rosenbrock's growth at z: three stages of y' = z y / h, each solved with 1 - gamma z. */
static double rosenbrock_growth(const double complex z)
{
    const iso_rosenbrock *const t = &iso_table_ros3;
    const double complex gz = (double)t->gamma * z;
    const double complex solver = 1.0 / (1.0 - gz);
    const double complex k1 = solver * gz;
    const double complex derivative = gz * (1.0 + (double)t->a21 * k1);
    const double complex k2 = solver * (derivative + (double)t->gamma * (double)t->c21 * k1);
    const double complex k3 = solver * (derivative + (double)t->gamma * ((double)t->c31 * k1 + (double)t->c32 * k2));
    return cabs(1.0 + (double)t->m[0] * k1 + (double)t->m[1] * k2 + (double)t->m[2] * k3);
}

static double energy(const hard_run *const run)
{
    const double x = (double)run->x[POSITION];
    const double v = (double)run->x[SPEED];
    return 0.5 * ((double)STIFFNESS * x * x + (double)MASS * v * v);
}

/* The factor of the amplitude per step in free vibration, over `ticks` steps after the first 8. */
static double observed(const unsigned method, const int ticks)
{
    enum { SETTLE = 8 };
    static hard_run run;
    hard_begin(&run, &problems[0], method, STEP);
    run.x[POSITION] = R(1e-3);
    hard_prime(&run);
    (void)hard_go(&run, SETTLE);
    const double before = energy(&run);
    (void)hard_go(&run, ticks);
    return pow(energy(&run) / before, 0.5 / ticks);
}

static void test_settles(const hard_problem *const problem, const unsigned method)
{
    enum { TICKS = 1000 };
    static hard_run run;
    hard_begin(&run, problem, method, STEP);
    run.u[0] = FORCE;
    hard_prime(&run);
    const bool finite = hard_go(&run, TICKS) == TICKS;
    const double stand = (double)FORCE / (double)STIFFNESS;
    const double error = fabs((double)run.x[POSITION] - stand) / stand;
    report_ok(finite && error <= 4.0 * (double)ISO_REAL_EPSILON, "%s, %s at 1 kHz: stands at F / k to %.1e after 1 s",
              problem->name, hard_name(method), error);
}

int main(void)
{
    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++) {
        test_settles(&problems[i], ISO_BDF4);
        test_settles(&problems[i], ISO_ROSENBROCK);
    }

    const double complex z = 10.0 * (double complex)I;
    const double rosenbrock = observed(ISO_ROSENBROCK, 20);
    report_ok(fabs(rosenbrock / rosenbrock_growth(z) - 1.0) <= 40.0 * (double)ISO_REAL_EPSILON,
              "rosenbrock: %.9f a step, |R(10 i)| = %.9f", rosenbrock, rosenbrock_growth(z));
    const double bdf4 = observed(ISO_BDF4, 200);
    report_ok(fabs(bdf4 / hard_bdf4_growth(0.0, 10.0) - 1.0) <= 1e-3,
              "bdf4: %.6f a step, by its characteristic polynomial %.6f", bdf4, hard_bdf4_growth(0.0, 10.0));

    for (size_t i = 0; i < sizeof problems / sizeof *problems; i++) {
        for (unsigned method = ISO_EULER; method <= ISO_ABM4_PECECE; method++) {
            hard_problem moved = problems[i];
            moved.start[POSITION] = 1e-3;
            hard_expect_failure(&moved, method, STEP, 600);
        }
    }
    return report_done();
}
