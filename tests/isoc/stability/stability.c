/* Where methods are stable: kernels run on x' = lambda x, against what is published of them (theory.h).
 *
 * With h = 1 and z = lambda, x' = z x with complex x is a plant of two real states. A run is linear: it is scaled by
 * powers of two, which change no digit, and its growth per step is measured over STEPS steps after as many before,
 * which leave the largest root alone. Two roots of the same size, a conjugate pair on the real axis, make the size
 * swing; with a factor below 50, which is what is seen, growth is known to log(50) / STEPS.
 */
#include <math.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/dense.h"
#include "core/methods/primed.h"
#include "tests/host/report.h"
#include "tests/isoc/stability/theory.h"

enum { STEPS = 8000, N = 2, STATE_MAX = 9 * N, WORK_MAX = ISO_PRIME_VECTORS * N };

#define GROWTH_TOLERANCE 5e-4

/* A limit is where growth passes this; growth rises by 6e-3 or more in a hundredth of every limit here. */
#define UNSTABLE 1e-3
#define LIMIT_TOLERANCE 0.01

/* Of the theory, in double. */
#define ROUNDING 1e-12

static const char *const names[ISO_METHODS] = ISO_METHOD_NAMES;

/* x' = z x, p = {Re z, Im z}. */
static void rotate(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    dx[0] = p[0] * x[0] - p[1] * x[1];
    dx[1] = p[1] * x[0] + p[0] * x[1];
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    lu[0] = p[0];
    lu[1] = -p[1];
    lu[2] = p[1];
    lu[3] = p[0];
    iso_dense_factor(lu, N, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, N);
}

/* q' = v, v' = Re z v - (Im z)^2 q. */
static void mechanical(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    dx[0] = x[1];
    dx[1] = p[0] * x[1] - p[1] * p[1] * x[0];
}

static const iso_equations linear = {rotate, factor, solve, .factors = N * N};
static const iso_equations second_order = {.derivative = mechanical};

typedef struct run {
    unsigned recipe;
    real p[2];
    real x[STATE_MAX];
    iso_any_progress progress;
    double scale; /* log2 of what x has been divided by */
} run;

static void begin(run *const r, const unsigned recipe, const double complex z)
{
    real work[WORK_MAX], lu[N * N];
    memset(r, 0, sizeof *r);
    r->recipe = recipe;
    r->p[0] = (real)creal(z);
    r->p[1] = (real)cimag(z);
    r->x[0] = R(0.6);
    r->x[1] = R(0.8);
    iso_method_prime(recipe, N, ISO_IS(recipe, ISO_SEMI_IMPLICIT) ? &second_order : &linear, R(1.0), r->x, NULL, r->p,
                     lu, work, &r->progress.progress);
}

static void step(run *const r)
{
    real work[WORK_MAX] = {R(0.0)}, lu[N * N];
    iso_method_step(r->recipe, N, ISO_IS(r->recipe, ISO_SEMI_IMPLICIT) ? &second_order : &linear, R(1.0), r->x, NULL,
                    r->p, lu, work, &r->progress.progress);
}

/* log2 of the size of all that the method keeps. */
static double size_of(run *const r)
{
    double square = 0.0;
    for (int i = 0; i < STATE_MAX; i++) {
        square += (double)r->x[i] * (double)r->x[i];
    }
    const int exponent = ilogb(square) / 2;
    if (exponent > 10 || exponent < -10) {
        for (int i = 0; i < STATE_MAX; i++) {
            r->x[i] = (real)ldexp((double)r->x[i], -exponent);
        }
        r->scale += exponent;
        square = ldexp(square, -2 * exponent);
    }
    return r->scale + 0.5 * log2(square);
}

/* The logarithm of the growth per step. */
static double measured_growth(const unsigned recipe, const double complex z)
{
    run r;
    double before = 0.0, after = 0.0;
    begin(&r, recipe, z);
    for (int i = 0; i < 2 * STEPS; i++) {
        step(&r);
        after = size_of(&r);
        before = i == STEPS ? after : before;
    }
    return (after - before) * log(2.0) / (STEPS - 1);
}

/* At these z, in the left half plane and on the axes, the logarithms of growth agree. The position of semi_implicit
 * stays. */
static void test_growth(const unsigned recipe)
{
    static const double size[] = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 30.0};
    const double complex ray[] = {-1.0, IMAGINARY, -sqrt(0.5) + sqrt(0.5) * IMAGINARY};
    const int rays = ISO_IS(recipe, ISO_SEMI_IMPLICIT) ? 2 : 3;
    double worst = 0.0;
    for (int i = 0; i < rays; i++) {
        for (size_t j = 0; j < sizeof size / sizeof *size; j++) {
            const double complex z = size[j] * ray[i];
            const double known = theory_growth(recipe, z),
                         least = ISO_IS(recipe, ISO_SEMI_IMPLICIT) && i == 0 ? 1.0 : 0.0;
            worst = fmax(worst, fabs(measured_growth(recipe, z) - log(fmax(known, least))));
        }
    }
    report_ok(worst <= GROWTH_TOLERANCE, "%s: growth per step is the theory's, |difference of logarithms| %.1e",
              names[recipe], worst);
}

typedef double growth_function(unsigned recipe, double complex z);

static double theory_log_growth(const unsigned recipe, const double complex z)
{
    return log(theory_growth(recipe, z));
}

/* The first |z| along a ray where growth passes a threshold, by steps of 5 % from 0.05 to 40 and then by bisection. */
static double limit_of(growth_function *const growth, const unsigned recipe, const double complex ray,
                       const double threshold)
{
    double low = 0.05;
    double high = low;
    while (high < 40.0 && growth(recipe, high * ray) <= threshold) {
        low = high;
        high *= 1.05;
    }
    if (high == low || high >= 40.0) {
        return high == low ? 0.0 : HUGE_VAL;
    }
    while (high - low > 1e-5 * low) {
        const double middle = 0.5 * (low + high);
        *(growth(recipe, middle * ray) <= threshold ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/* `known`, to five digits, is what is published; 0 where nothing precise is. */
static void test_limit(const unsigned recipe, const double complex ray, const char *const axis, const double known)
{
    const double theory = limit_of(theory_log_growth, recipe, ray, ROUNDING);
    const double measured = limit_of(measured_growth, recipe, ray, UNSTABLE);
    report_ok(fabs(measured - theory) <= LIMIT_TOLERANCE * theory &&
                  (known == 0.0 || fabs(theory - known) <= 2e-5 * known),
              "%s: limit on the %s axis %.5f, root locus %.5f", names[recipe], axis, measured, theory);
}

/* Published: Hairer and Wanner (1996), IV.2 and V.1. */
static void test_limits(void)
{
    test_limit(ISO_EULER, -1.0, "real", 2.0);
    test_limit(ISO_HEUN, -1.0, "real", 2.0);
    test_limit(ISO_RK4, -1.0, "real", 2.785293563405282);
    test_limit(ISO_AB4, -1.0, "real", 0.3);
    test_limit(ISO_SEMI_IMPLICIT, -1.0, "real", 2.0);
    test_limit(ISO_ABM4, -1.0, "real", 0.0);
    test_limit(ISO_ABM4_PEC, -1.0, "real", 0.0);
    test_limit(ISO_ABM4_PECECE, -1.0, "real", 0.0);
    test_limit(ISO_RK4, IMAGINARY, "imaginary", 2.828427124746190);
    test_limit(ISO_AB4, IMAGINARY, "imaginary", 0.0);
    test_limit(ISO_SEMI_IMPLICIT, IMAGINARY, "imaginary", 2.0);

    const double rk4 = limit_of(measured_growth, ISO_RK4, -1.0, UNSTABLE);
    report_ok(fabs(rk4 - 1.02 * 2.785293563405282) > LIMIT_TOLERANCE * rk4, "control: a limit 2 %% off is noticed");
    report_ok(fabs(measured_growth(ISO_ABM4, -0.5) - log(theory_growth(ISO_ABM4_PECECE, -0.5))) > GROWTH_TOLERANCE,
              "control: the growth of another form of abm4 is noticed");
}

/* On the imaginary axis these grow however small the step is, as |R| or the root locus say; bdf4 does up to 4.71. */
static void test_imaginary_axis(void)
{
    static const unsigned growing[] = {ISO_EULER, ISO_HEUN, ISO_ABM4, ISO_ABM4_PEC, ISO_ABM4_PECECE, ISO_BDF4};
    static const double y[] = {0.4, 0.6, 0.8, 1.0};
    for (size_t m = 0; m < sizeof growing / sizeof *growing; m++) {
        bool grows = true;
        for (size_t i = 0; i < sizeof y / sizeof *y; i++) {
            grows = grows && theory_growth(growing[m], 0.1 * y[i] * IMAGINARY) > 1.0 &&
                    measured_growth(growing[m], y[i] * IMAGINARY) > 10.0 * (double)ISO_REAL_EPSILON;
        }
        report_ok(grows, "%s: grows on the imaginary axis: by %.1e a step at 0.4 i, %.1e at i", names[growing[m]],
                  measured_growth(growing[m], 0.4 * IMAGINARY), measured_growth(growing[m], IMAGINARY));
    }
    report_ok(measured_growth(ISO_BDF4, 4.6 * IMAGINARY) > 0.0 && measured_growth(ISO_BDF4, 4.8 * IMAGINARY) < 0.0,
              "bdf4: grows at 4.6 i and decays at 4.8 i");
}

/* One step h of x' = i x multiplies the size by |R(i h)|: terms up to 1, some ten roundings of half an epsilon. */
static double oscillator_growth(const unsigned recipe, const double h)
{
    const real p[2] = {R(0.0), R(1.0)};
    real x[STATE_MAX] = {R(0.6), R(0.8)}, work[WORK_MAX] = {R(0.0)}, lu[N * N];
    iso_any_progress progress = {{.local_error = R(0.0)}};
    const double before = hypot((double)x[0], (double)x[1]);
    iso_method_step(recipe, N, &linear, (real)h, x, NULL, p, lu, work, &progress.progress);
    return hypot((double)x[0], (double)x[1]) / before;
}

static void test_oscillator(void)
{
    static const double h[] = {0.01, 0.1, 0.5, 1.0};
    static const struct {
        unsigned recipe;
        double published[4]; /* to 16 digits, from closed forms at 25 */
    } growing[] = {
        {ISO_EULER, {1.000049998750062, 1.004987562112089, 1.118033988749895, 1.414213562373095}},
        {ISO_HEUN, {1.000000001250000, 1.000012499921876, 1.007782218537319, 1.118033988749895}},
        {ISO_RK4, {0.9999999999999931, 0.9999999930642361, 0.9998948783722911, 0.9939050368230469}},
        {ISO_ROSENBROCK, {0.0}},
    };
    const double tolerance = 8.0 * (double)ISO_REAL_EPSILON;
    for (size_t m = 0; m < sizeof growing / sizeof *growing; m++) {
        const unsigned recipe = growing[m].recipe;
        double worst = 0.0;
        bool good = true;
        for (size_t i = 0; i < 4; i++) {
            const double want = theory_growth(recipe, h[i] * IMAGINARY);
            const double published = growing[m].published[i];
            worst = fmax(worst, fabs(oscillator_growth(recipe, h[i]) - want));
            good = good && (published == 0.0 || fabs(want - published) <= 1e-15);
        }
        report_ok(good && worst <= tolerance, "%s: |R(ih)| of the oscillator to %.1f epsilon", names[recipe],
                  worst / (double)ISO_REAL_EPSILON);
    }
    report_ok(fabs(oscillator_growth(ISO_RK4, 0.5) - theory_growth(ISO_HEUN, 0.5 * IMAGINARY)) > tolerance,
              "control: the growth of another method is noticed");
}

/* The z on bdf4's root locus at zeta = exp(i angle): sum over k of (1 - 1/zeta)^k / k. */
static double complex bdf4_locus(const double angle)
{
    const double complex back = 1.0 - cexp(-IMAGINARY * angle);
    return back + back * back / 2.0 + back * back * back / 3.0 + back * back * back * back / 4.0;
}

/* The z of this angle from the negative real axis. */
static double complex ray_at(const double degrees)
{
    const double angle = degrees * acos(-1.0) / 180.0;
    return -cos(angle) + sin(angle) * IMAGINARY;
}

/* A(alpha): the root locus leaves a wedge of alpha = 73.35 degrees free (Hairer and Wanner 1996, table V.2.1), and
 * touches it at `touch`. Just inside every run decays, just outside one there grows. */
static void test_wedge(void)
{
    double alpha = 90.0, touch = 0.0;
    for (int i = 1; i <= 30000; i++) {
        const double complex z = bdf4_locus(i * 1e-4);
        const double angle = 180.0 - carg(z) * 180.0 / acos(-1.0);
        touch = angle < alpha ? cabs(z) : touch;
        alpha = fmin(alpha, angle);
    }
    report_ok(fabs(alpha - 73.351676) < 1e-4, "bdf4: the root locus leaves %.4f degrees free, touched at |z| = %.3f",
              alpha, touch);

    double low = 60.0;
    double high = 89.0;
    while (high - low > 1e-3) {
        const double middle = 0.5 * (low + high);
        *(measured_growth(ISO_BDF4, touch * ray_at(middle)) <= 0.0 ? &low : &high) = middle;
    }
    report_ok(fabs(low - alpha) < 0.01, "bdf4: runs at |z| = %.3f grow from %.3f degrees on", touch, low);

    bool decays = true;
    for (double size = 0.1; size < 1e4; size *= 1.25) {
        decays = decays && measured_growth(ISO_BDF4, size * ray_at(73.25)) < 0.0;
    }
    report_ok(decays, "bdf4: runs inside, at 73.25 degrees, decay for |z| from 0.1 to 10000");
    report_ok(measured_growth(ISO_BDF4, touch * ray_at(73.45)) > 0.0, "bdf4: a run outside, at 73.45 degrees, grows");
}

/* Without end on the negative real axis: R(infinity) = 0, and all roots of bdf4 tend to 0. */
static void test_stiff(void)
{
    static const double z[] = {-1e1, -1e2, -1e4, -1e6, -1e8};
    bool bounded = true, gone = true;
    for (size_t i = 0; i < sizeof z / sizeof *z; i++) {
        run r;
        begin(&r, ISO_ROSENBROCK, z[i]);
        step(&r);
        const double left = hypot((double)r.x[0], (double)r.x[1]);
        const double rounding = 32.0 * (double)ISO_REAL_EPSILON;
        gone = gone && fabs(left - theory_growth(ISO_ROSENBROCK, z[i])) <= rounding;
        bounded = bounded && measured_growth(ISO_BDF4, z[i]) < -0.5;
    }
    report_ok(gone, "rosenbrock: one step leaves |R(z)| to rounding for z = -10 to -1e8, %.1e at the end",
              theory_growth(ISO_ROSENBROCK, -1e8));
    report_ok(bounded, "bdf4: decays for z = -10 to -1e8");
    report_ok(measured_growth(ISO_RK4, -1e2) > 0.0, "control: rk4 grows at -100");
}

int main(void)
{
    for (unsigned m = 0; m < ISO_METHODS; m++) {
        if (!ISO_IS_VARYING(m)) {
            test_growth(m);
        }
    }
    test_limits();
    test_imaginary_axis();
    test_oscillator();
    test_wedge();
    test_stiff();
    return report_done();
}
