/* core/multistep.h: Adams-Bashforth of order four and its priming, against results that are exact in binary. */
#include "core/multistep.h"
#include "tests/tap.h"

enum { N = 2 };

/* With h = 1.5, h / 24 = 1/16 and every number below is exact. */
static const real h = R(1.5);

/* t' = 1, q' = t^3: rk4 integrates it without error, so the primed history is exact. */
static void cubic(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = x[0] * x[0] * x[0];
}

/* q' = v, v' = -q. */
static void oscillator(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = -x[0];
}

/* q' = u p. */
static void driven(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)x;
    dx[0] = u[0] * p[0];
}

static void test_prime(void)
{
    real history[ISO_AB4_HISTORY(N) + 1], at[N], work[ISO_EXPLICIT_WORK(N)];
    const real x[N] = {R(3.0), R(0.0)};
    history[ISO_AB4_HISTORY(N)] = R(7.0);
    iso_ab4_prime(N, cubic, h, x, NULL, NULL, history, at, work);

    tap_ok(x[0] == R(3.0) && x[1] == R(0.0), "prime: the state is left as it is");
    tap_same(history[0 * N + 1], R(3.375), "prime: the newest slope is the one at t - h");
    tap_same(history[1 * N + 1], R(0.0), "prime: then the one at t - 2h");
    tap_same(history[2 * N + 1], R(-3.375), "prime: then the one at t - 3h");
    tap_ok(history[0] == R(1.0) && history[N] == R(1.0) && history[2 * N] == R(1.0), "prime: slopes of every state");
    tap_same(history[ISO_AB4_HISTORY(N)], R(7.0), "prime: the history ends where its size says");
}

static void test_cubic(void)
{
    real history[ISO_AB4_HISTORY(N)], at[N], work[ISO_EXPLICIT_WORK(N)], slope[N];
    real x[N] = {R(0.0), R(0.0)};
    iso_ab4_prime(N, cubic, h, x, NULL, NULL, history, at, work);
    iso_ab4_step(N, cubic, h, x, NULL, NULL, history, slope);
    tap_same(x[0], R(1.5), "step: time advances by h");
    tap_same(x[1], R(1.265625), "step: the integral of a cubic slope is exact");
    tap_same(history[0 * N + 1], R(0.0), "step: the slope used last is now the newest of the history");
    tap_same(history[1 * N + 1], R(-3.375), "step: the history moves on by one");
    tap_same(history[2 * N + 1], R(-27.0), "step: the history moves on by two");
    iso_ab4_step(N, cubic, h, x, NULL, NULL, history, slope);
    tap_same(x[1], R(20.25), "step: exact in the second step too");
}

/* By hand: 16 dq = 55*0 - 59*1 + 37*2 - 9*3 = -12 and 16 dv = 55*(-1) - 59*(-2) + 37*4 - 9*0 = 211. */
static void test_by_hand(void)
{
    real history[ISO_AB4_HISTORY(N)] = {R(1.0), R(-2.0), R(2.0), R(4.0), R(3.0), R(0.0)};
    real slope[N];
    real x[N] = {R(1.0), R(0.0)};
    iso_ab4_step(N, oscillator, h, x, NULL, NULL, history, slope);
    tap_same(x[0], R(0.25), "step: position by hand");
    tap_same(x[1], R(13.1875), "step: speed by hand");
}

static void test_inputs(void)
{
    real history[ISO_AB4_HISTORY(1)], at[1], work[ISO_EXPLICIT_WORK(1)], slope[1];
    const real u[1] = {R(3.0)};
    const real p[1] = {R(0.5)};
    real x[1] = {R(1.0)};
    iso_ab4_prime(1, driven, h, x, u, p, history, at, work);
    tap_same(history[2], R(1.5), "prime: inputs and parameters reach the derivative");
    iso_ab4_step(1, driven, h, x, u, p, history, slope);
    tap_same(x[0], R(3.25), "step: inputs and parameters reach the derivative");
}

/* With n known to the compiler, and known only when it runs: the same bits. */
static void test_unrolled(void)
{
    volatile size_t any = N;
    const size_t n = any;
    real fixed[ISO_AB4_HISTORY(N)], history[ISO_AB4_HISTORY(N)], at[N], work[ISO_EXPLICIT_WORK(N)], slope[N];
    real x[N] = {R(1.0), R(0.1)};
    real y[N] = {R(1.0), R(0.1)};
    iso_ab4_prime(N, oscillator, R(0.01), x, NULL, NULL, fixed, at, work);
    iso_ab4_prime(n, oscillator, R(0.01), y, NULL, NULL, history, at, work);
    tap_ok(memcmp(fixed, history, sizeof history) == 0, "prime: unrolled and run-time size give the same bits");
    for (unsigned i = 0; i < 200; i++) {
        iso_ab4_step(N, oscillator, R(0.01), x, NULL, NULL, fixed, slope);
        iso_ab4_step(n, oscillator, R(0.01), y, NULL, NULL, history, slope);
    }
    tap_ok(memcmp(x, y, sizeof x) == 0 && x[0] < R(0.0), "step: unrolled and run-time size give the same bits");
}

int main(void)
{
    test_prime();
    test_cubic();
    test_by_hand();
    test_inputs();
    test_unrolled();
    tap_done();
}
