/* Orders of core/methods/multirate.h, of a motor whose current has sub-steps: against the closed form of a winding with
 * its rotor, which is linear, and against a fine solution of one whose torque and inductance vary.
 *
 * States as isoc has them: angle, current, speed; the current is fast. Errors are those of the run's end and of all
 * ticks before it, over 3 A and 120 rad/s.
 */
#include <math.h>

#include "core/methods/all.h"
#include "core/methods/multirate.h"
#include "tests/host/report.h"

static const char *const names[] = ISO_METHOD_NAMES;

enum { N = 3, HALVINGS = 6, WORK = ISO_MULTIRATE_WORK(ISO_RK4, N, 1, 2) };

static const double resistance = 2.0, inductance = 5e-3, constant = 0.05, inertia = 2e-5, drag = 1e-5, volts = 6.0,
                    length = 0.04; /* s */

/* Of both kinds: `bent` is 0 of the linear one, else 1. */
static void slope_of(const double x[N], const double bent, double d[N])
{
    if (bent < 0.0) {
        d[0] = x[2];
        d[1] = -constant * x[2] / inductance;
        d[2] = constant * x[1] / inertia;
        return;
    }
    const double torque = constant * (1.0 + bent * 0.3 * sin(x[0]));
    const double store = inductance * (1.0 + bent * 0.2 * x[1] * x[1]);
    d[0] = x[2];
    d[1] = (volts - resistance * x[1] - torque * x[2]) / store;
    d[2] = (torque * x[1] - drag * x[2] * (1.0 + bent * x[2])) / inertia;
}

static void slope(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                  const real *restrict const p)
{
    const double at[N] = {(double)x[0], (double)x[1], (double)x[2]};
    double d[N];
    (void)u;
    slope_of(at, (double)p[0], d);
    for (int i = 0; i < N; i++) {
        dx[i] = (real)d[i];
    }
}

static void fast_slope(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    real all[N];
    slope(all, x, u, p);
    dx[0] = all[1];
}

static const uint16_t fast_states[] = {1}, reads[] = {0, 2};
static const bool is_fast[N] = {false, true, false};
static const iso_equations equations = {.derivative = slope};

/* The linear one by the whole series of the exponential, in long double; the other by small steps of rk4. */
static void advance_exactly(double x[N], const double bent, const double h)
{
    enum { TERMS = 30, FINE = 64 };
    if (bent == 0.0) {
        long double term[N], made[N];
        double d[N];
        slope_of(x, 0.0, d);
        for (int i = 0; i < N; i++) {
            made[i] = (long double)x[i];
            term[i] = (long double)d[i];
        }
        for (int n = 1; n <= TERMS; n++) {
            for (int i = 0; i < N; i++) {
                term[i] *= (long double)h / (long double)n;
                made[i] += term[i];
            }
            const long double now[N] = {term[0], term[1], term[2]};
            term[0] = now[2];
            term[1] = (-(long double)resistance * now[1] - (long double)constant * now[2]) / (long double)inductance;
            term[2] = ((long double)constant * now[1] - (long double)drag * now[2]) / (long double)inertia;
        }
        for (int i = 0; i < N; i++) {
            x[i] = (double)made[i];
        }
        return;
    }
    for (int part = 0; part < FINE; part++) {
        const double fine = h / FINE, c[4] = {0.0, 0.5, 0.5, 1.0};
        double k[4][N], at[N];
        for (int s = 0; s < 4; s++) {
            for (int i = 0; i < N; i++) {
                at[i] = x[i] + (s > 0 ? c[s] * fine * k[s - 1][i] : 0.0);
            }
            slope_of(at, bent, k[s]);
        }
        for (int i = 0; i < N; i++) {
            x[i] += fine / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        }
    }
}

/* The largest error over the run, with so many steps and sub-steps. */
static double error_of(const unsigned recipe, const double bent, const int steps, const int substeps)
{
    const iso_fast fast = {fast_slope, fast_states, 1, is_fast, reads, 2, substeps};
    const real p[1] = {(real)bent};
    const double h = length / steps, size[N] = {1.0, 3.0, 120.0};
    real x[N] = {R(0.0)}, work[WORK];
    double right[N] = {0.0}, worst = 0.0;
    for (int n = 0; n < steps; n++) {
        iso_multirate_step(recipe, N, &equations, &fast, (real)h, x, NULL, p, work);
        advance_exactly(right, bent, h);
        for (int i = 0; i < N; i++) {
            worst = fmax(worst, fabs((double)x[i] - right[i]) / size[i]);
        }
    }
    return worst;
}

/* Halving the step divides the error by two to the order; the last halving is told that is not within rounding. A step
 * rounds some ten times by half an epsilon, and signs differ: at five times that the order is known to a third. */
static void test_order(const unsigned recipe, const double bent, const int first, const int substeps,
                       const double least, const double most)
{
    double before = error_of(recipe, bent, first, substeps), order = 0.0;
    int seen = 0;
    for (int i = 1; i <= HALVINGS; i++) {
        const int steps = first << i;
        const double error = error_of(recipe, bent, steps, substeps);
        if (error > 25.0 * (double)ISO_REAL_EPSILON * sqrt(steps)) {
            order = log2(before / error);
            seen++;
        }
        before = error;
    }
    report_ok(seen > 0 && order >= least && order <= most,
              "%s, %d sub-steps, %s: order %.2f after %d halvings, at least %.1f and at most %.1f", names[recipe],
              substeps, bent == 0.0 ? "linear" : "bent", order, seen, least, most);
}

/* Without resistance and drag, energy goes between the current and the speed for ever, by a quarter of a rad in a
 * step. Returns what a thousand steps leave of 1. */
static double energy_left(const unsigned recipe, const int substeps)
{
    const iso_fast fast = {fast_slope, fast_states, 1, is_fast, reads, 2, substeps};
    const iso_equations lossless = {.derivative = slope};
    const real p[1] = {R(-1.0)};
    real x[N] = {R(0.0), R(1.0), R(0.0)}, work[WORK];
    const real h = (real)(0.25 * sqrt(inductance * inertia) / constant);
    for (int n = 0; n < 1000; n++) {
        if (substeps > 1) {
            iso_multirate_step(recipe, N, &lossless, &fast, h, x, NULL, p, work);
        } else {
            iso_method_step(recipe, N, &lossless, h, x, NULL, p, NULL, work, NULL);
        }
    }
    return ((double)x[1] * (double)x[1] * inductance + (double)x[2] * (double)x[2] * inertia) / inductance;
}
/* Sub-steps add no more to it, and take no more, than the method does alone. */
static void test_energy(const unsigned recipe)
{
    const double alone = energy_left(recipe, 1), parted = energy_left(recipe, 4);
    report_ok(fabs(parted - 1.0) <= fabs(alone - 1.0),
              "%s: of the energy of an exchange without loss, %.5g is left; with sub-steps %.5g", names[recipe], alone,
              parted);
}

int main(void)
{
    for (int bent = 0; bent < 2; bent++) {
        test_order(ISO_EULER, bent, 20, 4, 0.9, 1.1);
        test_order(ISO_HEUN, bent, 20, 4, 1.8, 2.6);
        test_order(ISO_RK4, bent, 10, 4, 2.9, 4.1);
    }
    test_order(ISO_RK4, 0.0, 10, 16, 2.9, 4.1);
    for (unsigned recipe = ISO_EULER; recipe <= ISO_RK4; recipe++) {
        test_energy(recipe);
    }
    return report_done();
}
