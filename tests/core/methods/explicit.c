/* core/methods/explicit.h and semi_implicit.h: euler, heun, rk4 and semi-implicit Euler against results that are exact
 * in binary. */
#include "core/methods/euler.h"
#include "core/methods/heun.h"
#include "core/methods/rk4.h"
#include "core/methods/semi_implicit.h"
#include "tests/core/methods/equations.h"
#include "tests/one_step.h"
#include "tests/tap.h"

enum { N_MAX = 3 };

/* With h = 1.5 the divisions by 2 and 6 are exact, and so is every number below. */
static const real h = R(1.5);
static const real h_oscillator = R(0.75);

/* t' = 1, q' = t. */
static void linear(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = x[0];
}

/* Lorenz (1963): every rounding shows. */
static void lorenz(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(10.0) * (x[1] - x[0]);
    dx[1] = x[0] * (R(28.0) - x[2]) - x[1];
    dx[2] = x[0] * x[1] - R(2.6666667) * x[2];
}

/* One step of a table from x[n], with nothing kept. */
static inline void step(const iso_tableau *const table, const size_t n, iso_derivative *const f, const real by,
                        real *const x, const real *const u, const real *const p, real *const work)
{
    const iso_history history = {.n = n, .x = x};
    (void)one_explicit_step(table, &history, f, by, u, p, work);
}

static void semi_implicit(const iso_history *const history, const iso_equations *const eq, real *const work)
{
    iso_step step = {.history = history, .equations = eq, .f = eq->derivative, .h = h_oscillator, .work = work};
    iso_evaluate(&step, work, history->x);
    iso_semi_implicit_step(&step);
}

static void test_euler(void)
{
    real work[ISO_EXPLICIT_VECTORS * N_MAX];
    real x[2] = {R(1.0), R(0.0)};
    step(&iso_tableau_euler, 2, oscillator, h_oscillator, x, NULL, NULL, work);
    tap_same(x[0], R(1.0), "euler: oscillator, position after one step");
    tap_same(x[1], R(-0.75), "euler: oscillator, speed after one step");
}

static void test_heun(void)
{
    real work[ISO_EXPLICIT_VECTORS * N_MAX];
    real x[2] = {R(1.0), R(0.0)};
    step(&iso_tableau_heun, 2, oscillator, h_oscillator, x, NULL, NULL, work);
    tap_same(x[0], R(0.71875), "heun: oscillator, position 1 - h^2/2");
    tap_same(x[1], R(-0.75), "heun: oscillator, speed -h");

    real y[2] = {R(2.0), R(0.0)};
    step(&iso_tableau_heun, 2, linear, h, y, NULL, NULL, work);
    tap_same(y[0], R(3.5), "heun: time advances by h");
    tap_same(y[1], R(4.125), "heun: the integral of a linear derivative is exact");
}

static void test_rk4(void)
{
    real work[ISO_EXPLICIT_VECTORS * N_MAX];
    real x[2] = {R(1.0), R(0.0)};
    step(&iso_tableau_rk4, 2, oscillator, h_oscillator, x, NULL, NULL, work);
    tap_same(x[0], R(0.73193359375), "rk4: oscillator, position 1 - h^2/2 + h^4/24");
    tap_same(x[1], R(-0.6796875), "rk4: oscillator, speed -h + h^3/6");

    real y[2] = {R(0.0), R(0.0)};
    step(&iso_tableau_rk4, 2, cubic, h, y, NULL, NULL, work);
    tap_same(y[1], R(1.265625), "rk4: the integral of a cubic derivative is exact");
    step(&iso_tableau_rk4, 2, cubic, -h, y, NULL, NULL, work);
    tap_same(y[0], R(0.0), "rk4: a step back undoes the time");
    tap_same(y[1], R(0.0), "rk4: a step back undoes the integral");
}

/* q' = v and v' = 0, beside an oscillator. */
static void steady_beside(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    oscillator(dx, x, u, p);
    dx[2] = R(0.1);
}

/* A steady state takes the derivative at the start alone, which rounds once; the others do not know of it. */
static void test_steady(void)
{
    static const bool steady[3] = {false, false, true};
    real work[ISO_EXPLICIT_VECTORS * 3], x[3] = {R(1.0), R(0.0), R(7.0)}, alone[2] = {R(1.0), R(0.0)};
    const iso_history history = {.n = 3, .x = x};
    const iso_equations eq = {.derivative = steady_beside, .steady = steady};
    iso_step once = {.history = &history, .equations = &eq, .f = eq.derivative, .h = R(0.3), .work = work};
    iso_evaluate(&once, work, x);
    iso_explicit_step(&iso_tableau_rk4, &once);
    step(&iso_tableau_rk4, 2, oscillator, R(0.3), alone, NULL, NULL, work);
    tap_same(x[2], R(7.0) + R(0.3) * R(0.1), "rk4: a steady state moves by h times its derivative");
    tap_ok(x[0] == alone[0] && x[1] == alone[1], "rk4: the states beside it keep their bits");
}

/* Speed first, from the position before the step; the position from the speed after it. */
static void test_semi_implicit(void)
{
    real work[3] = {R(0.0), R(0.0), R(7.0)};
    real x[3] = {R(1.0), R(0.0), R(9.0)};
    const iso_history history = {.n = 2, .x = x};
    const iso_equations eq = {.derivative = oscillator};
    semi_implicit(&history, &eq, work);
    tap_same(x[1], R(-0.75), "semi_implicit: oscillator, speed v - h q");
    tap_same(x[0], R(0.4375), "semi_implicit: oscillator, position q + h (v - h q)");
    tap_ok(work[2] == R(7.0) && x[2] == R(9.0), "semi_implicit: work space and state end at n");

    /* Symplectic: q^2 - h q v + v^2 stays, here 1. */
    tap_same(x[0] * x[0] - h_oscillator * x[0] * x[1] + x[1] * x[1], R(1.0), "semi_implicit: the invariant stays");
    semi_implicit(&history, &eq, work);
    tap_same(x[0] * x[0] - h_oscillator * x[0] * x[1] + x[1] * x[1], R(1.0), "semi_implicit: in the second step too");
}

/* q1' = v, q2' = 2 v, v' = -q1: two positions of one speed. */
static void rates(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = x[2];
    dx[1] = R(2.0) * x[2];
}

static void coupled(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    rates(dx, x, u, p);
    dx[2] = -x[0];
}

/* More positions than speeds: the rates are those of the new speed. */
static void test_semi_implicit_rates(void)
{
    real work[4] = {R(0.0), R(0.0), R(0.0), R(7.0)};
    real x[4] = {R(1.0), R(3.0), R(0.0), R(9.0)};
    const iso_history history = {.n = 3, .x = x};
    const iso_equations eq = {.derivative = coupled, .rates = rates, .positions = 2};
    semi_implicit(&history, &eq, work);
    tap_same(x[2], R(-0.75), "semi_implicit: two positions, speed v - h q1");
    tap_same(x[0], R(0.4375), "semi_implicit: two positions, q1 + h (v - h q1)");
    tap_same(x[1], R(1.875), "semi_implicit: two positions, q2 + 2 h (v - h q1)");
    tap_ok(work[3] == R(7.0) && x[3] == R(9.0), "semi_implicit: two positions, work space and state end at n");
}

static void test_inputs(void)
{
    real work[ISO_EXPLICIT_VECTORS * N_MAX];
    const real u[1] = {R(3.0)};
    const real p[1] = {R(0.5)};
    real x[1] = {R(1.0)};
    step(&iso_tableau_rk4, 1, driven, h, x, u, p, work);
    tap_same(x[0], R(3.25), "inputs and parameters reach the derivative");
    tap_same(u[0], R(3.0), "inputs are left as they are");
}

/* Work space beyond what the size macro promises stays untouched. */
static void test_work(void)
{
    real work[ISO_EXPLICIT_VECTORS * 2 + 1];
    work[ISO_EXPLICIT_VECTORS * 2] = R(7.0);
    real x[3] = {R(1.0), R(0.0), R(9.0)};
    step(&iso_tableau_rk4, 2, oscillator, h, x, NULL, NULL, work);
    tap_same(work[ISO_EXPLICIT_VECTORS * 2], R(7.0), "work space ends where its size says");
    tap_same(x[2], R(9.0), "the state ends at n");
}

/* The kernel with table and n known to the compiler, and with both known only when it runs: the same bits. */
static inline void compare_unrolled(const iso_tableau *const fixed, const iso_tableau *const table, const size_t n,
                                    const char *const name)
{
    real work[ISO_EXPLICIT_VECTORS * N_MAX];
    real x[N_MAX] = {R(1.0), R(1.0), R(1.0)};
    real y[N_MAX] = {R(1.0), R(1.0), R(1.0)};
    for (unsigned i = 0; i < 200; i++) {
        step(fixed, N_MAX, lorenz, R(0.01), x, NULL, NULL, work);
        step(table, n, lorenz, R(0.01), y, NULL, NULL, work);
    }
    tap_ok(memcmp(x, y, sizeof x) == 0 && x[0] != R(1.0), name);
}

static void test_unrolled(void)
{
    const iso_tableau *volatile table = &iso_tableau_euler;
    volatile size_t n = N_MAX;
    compare_unrolled(&iso_tableau_euler, table, n, "euler: unrolled and run-time size give the same bits");
    table = &iso_tableau_heun;
    compare_unrolled(&iso_tableau_heun, table, n, "heun: unrolled and run-time size give the same bits");
    table = &iso_tableau_rk4;
    compare_unrolled(&iso_tableau_rk4, table, n, "rk4: unrolled and run-time size give the same bits");
}

/* x += h/6 ((k_1 + 2 (k_2 + k_3)) + k_4), with terms of one weight added first, and Heun's x += h/2 (k_1 + k_2): where
 * a sum has another order, or a product another place, the bits are others. */
static void rk4_as_written(real *const x, const real by)
{
    real k[4][N_MAX], at[N_MAX];
    lorenz(k[0], x, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        at[s] = x[s] + by / R(2.0) * k[0][s];
    }
    lorenz(k[1], at, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        at[s] = x[s] + by / R(2.0) * k[1][s];
    }
    lorenz(k[2], at, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        at[s] = x[s] + by * k[2][s];
    }
    lorenz(k[3], at, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        x[s] += by / R(6.0) * ((k[0][s] + R(2.0) * (k[1][s] + k[2][s])) + k[3][s]);
    }
}

static void heun_as_written(real *const x, const real by)
{
    real k[2][N_MAX], at[N_MAX];
    lorenz(k[0], x, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        at[s] = x[s] + by * k[0][s];
    }
    lorenz(k[1], at, NULL, NULL);
    for (size_t s = 0; s < N_MAX; s++) {
        x[s] += by / R(2.0) * (k[0][s] + k[1][s]);
    }
}

static void test_order_of_sums(void)
{
    static void (*const written[])(real * x, real by) = {rk4_as_written, heun_as_written};
    const iso_tableau *const tables[] = {&iso_tableau_rk4, &iso_tableau_heun};
    for (size_t m = 0; m < 2; m++) {
        real work[ISO_EXPLICIT_VECTORS * N_MAX];
        real x[N_MAX] = {R(1.0), R(1.0), R(1.0)}, y[N_MAX] = {R(1.0), R(1.0), R(1.0)};
        for (unsigned i = 0; i < 200; i++) {
            step(tables[m], N_MAX, lorenz, R(0.01), x, NULL, NULL, work);
            written[m](y, R(0.01));
        }
        tap_ok(memcmp(x, y, sizeof x) == 0, m == 0 ? "rk4: the bits of the formula as it is written"
                                                   : "heun: the bits of the formula as it is written");
    }
}

int main(void)
{
    test_order_of_sums();
    test_euler();
    test_heun();
    test_rk4();
    test_steady();
    test_semi_implicit();
    test_semi_implicit_rates();
    test_inputs();
    test_work();
    test_unrolled();
    tap_done();
}
