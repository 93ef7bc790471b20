/* core/methods/dense.h, bdf4.h and rosenbrock.h: factors, bdf4 and the linearly implicit method, each against numbers
 * found otherwise. */
#include "core/methods/bdf4.h"
#include "core/methods/dense.h"
#include "tests/tap.h"

static bool near(const real got, const real want, const real tolerance)
{
    return iso_abs(got - want) <= tolerance;
}

/* With hb = -1 and J = A - 1 the factors are those of A. */
static void factor_of(real *const lu, const real *const a, const size_t n)
{
    for (size_t i = 0; i < n * n; i++) {
        lu[i] = a[i] - (i % (n + 1) == 0 ? R(1.0) : R(0.0));
    }
    iso_dense_factor(lu, n, R(-1.0));
}

/* All pivots are powers of two, so that every number is exact. */
static void test_dense(void)
{
    static const real a1[1] = {R(4.0)};
    static const real a2[4] = {R(2.0), R(4.0), R(1.0), R(4.0)};
    static const real a3[9] = {R(2.0), R(4.0), R(-2.0), R(1.0), R(4.0), R(3.0), R(-2.0), R(0.0), R(14.0)};
    real lu[9], d1[1] = {R(6.0)}, d2[2] = {R(2.0), R(-1.0)}, d3[3] = {R(4.0), R(18.0), R(40.0)};

    factor_of(lu, a1, 1);
    iso_dense_solve(d1, lu, 1);
    tap_same(d1[0], R(1.5), "dense: one state");

    factor_of(lu, a2, 2);
    tap_ok(lu[0] == R(0.5) && lu[1] == R(4.0) && lu[2] == R(0.5) && lu[3] == R(0.5), "dense: L and U of two states");
    iso_dense_solve(d2, lu, 2);
    tap_ok(d2[0] == R(3.0) && d2[1] == R(-1.0), "dense: two states");

    factor_of(lu, a3, 3);
    tap_ok(lu[3] == R(0.5) && lu[6] == R(-1.0) && lu[7] == R(2.0), "dense: L of three states");
    tap_ok(lu[0] == R(0.5) && lu[4] == R(0.5) && lu[5] == R(4.0) && lu[8] == R(0.25), "dense: U of three states");
    iso_dense_solve(d3, lu, 3);
    tap_ok(d3[0] == R(1.0) && d3[1] == R(2.0) && d3[2] == R(3.0), "dense: three states");

    real j[1] = {R(3.0)};
    iso_dense_factor(j, 1, R(0.25));
    tap_same(j[0], R(4.0), "dense: the inverse of 1 - hb J");
}

/* t' = 1, q' = 4 t^3 and r' = 5 t^4. */
static void powers(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    const real t3 = x[0] * x[0] * x[0];
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = R(4.0) * t3;
    dx[2] = R(5.0) * (t3 * x[0]);
}

static void factor_powers(real *restrict lu, const real *restrict x, const real *restrict u, const real *restrict p,
                          const real hb)
{
    const real t2 = x[0] * x[0];
    (void)u;
    (void)p;
    memset(lu, 0, 9 * sizeof *lu);
    lu[3] = R(12.0) * t2;
    lu[6] = R(20.0) * (t2 * x[0]);
    iso_dense_factor(lu, 3, hb);
}

static void solve_3(real *restrict d, const real *restrict lu)
{
    iso_dense_solve(d, lu, 3);
}

/* x' = -u p x^2, whose Jacobian depends on everything. */
static void square(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    dx[0] = -(u[0] * p[0] * (x[0] * x[0]));
}

static void factor_square(real *restrict lu, const real *restrict x, const real *restrict u, const real *restrict p,
                          const real hb)
{
    lu[0] = R(-2.0) * (u[0] * p[0] * x[0]);
    iso_dense_factor(lu, 1, hb);
}

static void solve_1(real *restrict d, const real *restrict lu)
{
    iso_dense_solve(d, lu, 1);
}

/* x' = p x. */
static void decay(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    dx[0] = p[0] * x[0];
}

static void factor_decay(real *restrict lu, const real *restrict x, const real *restrict u, const real *restrict p,
                         const real hb)
{
    (void)x;
    (void)u;
    lu[0] = p[0];
    iso_dense_factor(lu, 1, hb);
}

static const iso_equations powers_equations = {powers, factor_powers, solve_3, .factors = 9};
static const iso_equations square_equations = {square, factor_square, solve_1, .factors = 1};
static const iso_equations decay_equations = {decay, factor_decay, solve_1, .factors = 1};

/* A step of bdf4, or its priming. */
static iso_step step_of(const iso_history *const history, const iso_equations *const eq, const real h,
                        const real *const u, const real *const p, real *const lu, real *const work)
{
    static iso_progress progress;
    return (iso_step){.history = history,
                      .equations = eq,
                      .f = eq->derivative,
                      .h = h,
                      .u = u,
                      .p = p,
                      .lu = lu,
                      .work = work,
                      .iterations = 2,
                      .progress = &progress};
}

/* From t = 1 to 2 after steps of 1. bdf4 is exact for t and t^4; for t^5 it gives (23 - 13 + 3*31 + 12*80) / 25 = 42.52
 * where 31 is right, and its predictor 4 - 6 + 4*31 - 211 = -89: the estimate is a fifth of 131.52. Roundings: some
 * ten of numbers up to 12*80/25 and, behind J, of t times 160 * 12/25; the tolerance is twice that. */
static void test_bdf4_powers(void)
{
    static const real past[12] = {R(1.0), R(1.0),   R(1.0),  R(1.0), R(-1.0),  R(1.0),
                                  R(1.0), R(-15.0), R(31.0), R(1.0), R(-65.0), R(211.0)};
    const real tolerance = R(1000.0) * ISO_REAL_EPSILON;
    real x[3] = {R(1.0), R(1.0), R(1.0)}, increments[13], lu[9], work[4 * 3 + 1];
    const iso_history history = {.n = 3, .x = x, .past = increments};
    memcpy(increments, past, sizeof past);
    increments[12] = R(7.0);
    work[4 * 3] = R(7.0);
    iso_step step = step_of(&history, &powers_equations, R(1.0), NULL, NULL, lu, work);
    iso_bdf4_step(&step);
    tap_ok(near(x[0], R(2.0), R(4.0) * ISO_REAL_EPSILON), "bdf4: time advances by h");
    tap_ok(near(x[1], R(16.0), tolerance), "bdf4: exact for degree four");
    tap_ok(near(x[2], R(43.52), tolerance), "bdf4: degree five, by hand");
    tap_ok(near(step.error, R(26.304), tolerance), "bdf4: the estimate, by hand");
    tap_ok(step.progress->residual <= tolerance, "bdf4: the second iteration finds nothing left of a linear problem");
    tap_ok(near(increments[1], R(15.0), tolerance) && increments[4] == R(1.0) && increments[10] == R(-15.0),
           "bdf4: the increments move on by one");
    tap_ok(increments[12] == R(7.0) && work[4 * 3] == R(7.0), "bdf4: memory ends where its size says");
}

/* From rest at 1 with hb = 1: dx = -(1 + dx)^2, so dx = (sqrt(5) - 3) / 2. Newton's matrix is 3 all the time: from 0 to
 * -1/3 to -10/27, and so on with a rate of 0.25. */
static void test_bdf4_newton(const uint8_t iterations, const real want, const real last, const char *const name)
{
    const real h = R(25.0) / R(12.0);
    const real u[1] = {R(4.0)}, p[1] = {R(0.25)};
    real x[1] = {R(1.0)}, increments[4] = {R(0.0), R(0.0), R(0.0), R(0.0)}, lu[1], work[4 * 1];
    const iso_history history = {.n = 1, .x = x, .past = increments};
    iso_step step = step_of(&history, &square_equations, h, u, p, lu, work);
    step.iterations = iterations;
    iso_bdf4_step(&step);
    const real residual = step.progress->residual;
    tap_ok(near(increments[0], want, R(4.0) * ISO_REAL_EPSILON) && near(residual, last, R(4.0) * ISO_REAL_EPSILON),
           name);
}

/* A state of 1 does not swallow what its increments need: with increments of 1/8 of its ulp and the derivative that
 * keeps them so, the next one is the same. */
static void test_bdf4_small(void)
{
    const real tiny = ISO_REAL_EPSILON / R(8.0);
    const real rate[1] = {tiny};
    real x[1] = {R(1.0)}, compensation[1] = {R(0.0)}, increments[4] = {tiny, tiny, tiny, tiny};
    real lu[1], work[4 * 1];
    const iso_history history = {.n = 1, .x = x, .past = increments, .compensation = compensation};
    for (uint32_t i = 0; i < 8; i++) {
        iso_step step = step_of(&history, &decay_equations, R(1.0), NULL, rate, lu, work);
        iso_bdf4_step(&step);
    }
    tap_ok(near(increments[0], tiny, R(8.0) * ISO_REAL_EPSILON * tiny) && x[0] == R(1.0) + ISO_REAL_EPSILON,
           "bdf4: increments below the ulp of the state, compensated");
}

static real rosenbrock(const iso_equations *const eq, const real from, const real h, const real *const u,
                       const real *const p)
{
    real x[1] = {from}, lu[1], work[ISO_ROSENBROCK_VECTORS * 1];
    const iso_history history = {.n = 1, .x = x};
    iso_step step = step_of(&history, eq, h, u, p, lu, work);
    iso_rosenbrock_step(&step);
    return x[0];
}

/* x' = p x with h = 1 gives R(p) = (1 + (1 - 3g) p + (1/2 - 3g + 3g^2) p^2) / (1 - g p)^3 (Hairer and Wanner 1996,
 * IV.6.2), here computed at 40 digits. Terms of a step are below 8, of 8 roundings each. */
static void test_rosenbrock(void)
{
    static const real z[] = {R(-0.25), R(-1.0), R(-10.0), R(0.0)};
    static const real want[] = {R(0.77873184228750385), R(0.36142380843112648), R(-0.12796095139099114), R(1.0)};
    const real tolerance = R(32.0) * ISO_REAL_EPSILON;
    bool linear = true;
    for (size_t i = 0; i < sizeof z / sizeof *z; i++) {
        linear = linear && near(rosenbrock(&decay_equations, R(1.0), R(1.0), NULL, z + i), want[i], tolerance);
    }
    tap_ok(linear, "rosenbrock: the stability function");

    const real stiff[1] = {R(-1.0) / ISO_REAL_EPSILON};
    tap_ok(iso_abs(rosenbrock(&decay_equations, R(1.0), R(1.0), NULL, stiff)) <= tolerance,
           "rosenbrock: a very stiff state is gone after one step");

    const real u[1] = {R(4.0)}, p[1] = {R(0.25)};
    tap_ok(near(rosenbrock(&square_equations, R(1.0), R(0.25), u, p), R(0.79977637339313754), tolerance),
           "rosenbrock: x' = -x^2, at 40 digits");
}

static void test_rosenbrock_keeps(void)
{
    real x[1] = {R(1.0)}, lu[1], work[ISO_ROSENBROCK_VECTORS * 1 + 1], check[4] = {R(0.0), R(0.0), R(0.0), R(7.0)};
    const real p[1] = {R(-0.25)};
    const iso_history history = {.n = 1, .x = x, .check = check, .checked = 3};
    work[ISO_ROSENBROCK_VECTORS * 1] = R(7.0);
    iso_step step = step_of(&history, &decay_equations, R(24.0), NULL, p, lu, work);
    iso_rosenbrock_step(&step);
    tap_ok(near(check[0], (x[0] - R(1.0)) + R(19.0) * R(0.25), R(32.0) * ISO_REAL_EPSILON) &&
               check[1] == R(-5.0) * R(0.25) && check[2] == R(-0.25),
           "rosenbrock: keeps derivative and increment for the next check");
    tap_ok(check[3] == R(7.0) && work[ISO_ROSENBROCK_VECTORS * 1] == R(7.0),
           "rosenbrock: memory ends where its size says");
}

/* From x = 2 on, x' = -x, or with -x / epsilon^2, which is at rest after one step; and t' = 1. */
static void test_bdf4_prime(void)
{
    static const real slow[1] = {R(-1.0)};
    const real stiff[1] = {R(-1.0) / (ISO_REAL_EPSILON * ISO_REAL_EPSILON)};
    const real h = R(0.0078125);
    real x[1] = {R(2.0)}, lu[1], work[ISO_BDF4_PRIME_VECTORS * 1 + 1], increments[ISO_BDF4_STEPS + 1];
    const iso_history history = {.n = 1, .x = x, .past = increments};
    work[ISO_BDF4_PRIME_VECTORS * 1] = increments[ISO_BDF4_STEPS] = R(7.0);
    iso_step step = step_of(&history, &decay_equations, h, NULL, slow, lu, work);
    iso_bdf4_prime(&step);

    /* The past of 2 e^-t by its series, e^h - 1 = 0.0078430972064479, and what the error of the polynomial, 126 h^5
     * x^(5) at most, makes of it, 7.4e-9. An increment, 2 h, has some eight roundings of half an epsilon, and the
     * weights that continue four of them by five steps, 56, -140, 120, -35, multiply that by 351: 2808 epsilons of h.
     */
    bool good = true;
    real at = R(2.0);
    for (size_t j = 0; j < ISO_BDF4_STEPS; j++) {
        const real before = at + R(0.0078430972064479) * at;
        good = good && iso_abs(increments[j] - (at - before)) <= R(7.4e-9) + R(2808.0) * ISO_REAL_EPSILON * h;
        at = before;
    }
    tap_ok(good, "bdf4: primed with the past of a smooth motion");
    tap_ok(x[0] == R(2.0) && increments[ISO_BDF4_STEPS] == R(7.0) && work[ISO_BDF4_PRIME_VECTORS * 1] == R(7.0),
           "bdf4: priming leaves the state, and its memory ends where its size says");

    step.p = stiff;
    iso_bdf4_prime(&step);
    good = true;
    for (size_t j = 0; j < ISO_BDF4_STEPS; j++) {
        good = good && iso_abs(increments[j]) <= ISO_REAL_EPSILON;
    }
    tap_ok(good, "bdf4: primed with the motion beyond a layer");
}

int main(void)
{
    test_dense();
    test_bdf4_powers();
    test_bdf4_newton(1, R(-1.0) / R(3.0), R(1.0) / R(3.0), "bdf4: one Newton iteration by hand");
    test_bdf4_newton(2, R(-10.0) / R(27.0), R(1.0) / R(27.0), "bdf4: two Newton iterations by hand");
    test_bdf4_newton(30, R(-0.38196601125010515), R(0.0), "bdf4: many Newton iterations reach the formula's solution");
    test_bdf4_small();
    test_rosenbrock();
    test_rosenbrock_keeps();
    test_bdf4_prime();
    tap_done();
}
