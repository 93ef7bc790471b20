/* Inputs that jump at every tick, and at times that pile up (Zeno's), on an oscillator of 10 rad/s damped by a tenth,
 * for two seconds. An input is held over a step, so that the solution is known in closed form from tick to tick.
 *
 * What must hold, in float and in double, for steps of 2^-7 s to 2^-11 s: a jump at a tick costs a one-step method
 * nothing, its order is what it always is. A method that keeps derivatives or increments has them from before the jump:
 * it falls to order one, the negative control, and is its own again where the jump starts it anew. Orders are means
 * over the four halvings, to 0.2, in double. In float the errors are those of the table, and 4 epsilons of rounding.
 */
#include <math.h>

#include "tests/promises/hard/hard.h"

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)p;
    dx[0] = x[1];
    dx[1] = u[0] - (R(2.0) * x[1] + R(100.0) * x[0]);
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    (void)p;
    lu[0] = R(0.0);
    lu[1] = R(1.0);
    lu[2] = R(-100.0);
    lu[3] = R(-2.0);
    iso_dense_factor(lu, 2, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 2);
}

static const hard_problem problem = {"oscillator", 2, {derivative, factor, solve, .factors = 4}, {0.01, 0.0}, NULL};

typedef real signal(long tick, int k);

static real alternating(const long tick, const int k)
{
    (void)k;
    return tick % 2 == 0 ? R(1.0) : R(-1.0);
}

/* As good as random: the highest bit of a multiplicative hash (Knuth 1998, The Art of Computer Programming 3, 6.4). */
static real noise(const long tick, const int k)
{
    (void)k;
    uint64_t state = (uint64_t)tick * UINT64_C(0x9E3779B97F4A7C15);
    state = (state ^ (state >> 31)) * UINT64_C(6364136223846793005);
    return (state >> 63) != 0 ? R(1.0) : R(-1.0);
}

/* Changes its sign at 1 - 2^-j s, j = 0, 1, 2, ...; from 1 s on it is zero. */
static real zeno(const long tick, const int k)
{
    double left = 1.0 - (double)tick / ldexp(1.0, k);
    real sign = R(1.0);
    while (left > 0.0 && left <= 0.5) {
        left *= 2.0;
        sign = -sign;
    }
    return left > 0.0 ? sign : R(0.0);
}

/* One step of h of the solution, with the input held. */
static void exact_step(long double x[2], const long double u, const long double h)
{
    const long double g = 1.0L;
    const long double w = sqrtl(99.0L);
    const long double away = x[0] - u / 100.0L;
    const long double c = cosl(w * h);
    const long double s = sinl(w * h) / w;
    const long double e = expl(-g * h);
    const long double v = x[1];
    x[0] = u / 100.0L + e * (away * c + (v + g * away) * s);
    x[1] = e * (v * c - (g * v + 100.0L * away) * s);
}

/* The largest error at a tick, of the speed or of 10 / s times the position; with h = 2^-k s. */
static double error_of(const unsigned recipe, signal *const input, const int k, const bool restart)
{
    static hard_run run;
    long double x[2] = {(long double)(real)0.01, 0.0L};
    double worst = 0.0;
    hard_begin(&run, &problem, recipe, ldexp(1.0, -k));
    run.u[0] = input(0, k);
    hard_prime(&run);
    for (long tick = 0; tick < 2L << k; tick++) {
        const real u = input(tick, k);
        if (restart && u != run.u[0]) {
            run.u[0] = u;
            hard_prime(&run);
        }
        run.u[0] = u;
        (void)hard_go(&run, 1);
        exact_step(x, (long double)u, ldexpl(1.0L, -k));
        worst = fmax(worst,
                     (double)fmaxl(10.0L * fabsl((long double)run.x[0] - x[0]), fabsl((long double)run.x[1] - x[1])));
    }
    return worst;
}

typedef struct inputs_method {
    unsigned method;
    bool keeps; /* derivatives or increments of steps before */
    int order;
    double error; /* at most, with 2^-COARSEST s */
} inputs_method;

enum { COARSEST = 7, FINEST = 11 };

static void test_method(const inputs_method *const m, signal *const input, const char *const name)
{
    const double slack = 0.2;
    double error[FINEST + 1];
    bool small = true;
    for (int k = COARSEST; k <= FINEST; k++) {
        error[k] = error_of(m->method, input, k, m->keeps);
        const double most = m->error * exp2(-(m->order - slack) * (k - COARSEST)) + 4.0 * (double)ISO_REAL_EPSILON;
        small = small && error[k] <= most;
    }
    const double order = log2(error[COARSEST] / error[FINEST]) / (FINEST - COARSEST);
    const char *const how = m->keeps ? ", started anew at jumps" : "";
    report_ok(small, "%s, %s%s: errors %.1e to %.1e", name, hard_name(m->method), how, error[COARSEST], error[FINEST]);
    if (sizeof(real) == sizeof(double)) {
        report_ok(order >= m->order - slack, "%s, %s%s: order %.2f", name, hard_name(m->method), how, order);
    }
    if (m->keeps) {
        const double stale = error_of(m->method, input, COARSEST, false) / error_of(m->method, input, FINEST, false);
        report_ok(log2(stale) / (FINEST - COARSEST) < 1.3, "control: %s, %s, with what it kept: order %.2f", name,
                  hard_name(m->method), log2(stale) / (FINEST - COARSEST));
    }
}

int main(void)
{
    static const inputs_method methods[] = {
        {ISO_EULER, false, 1, 6e-2},        {ISO_HEUN, false, 2, 1.2e-3},          {ISO_RK4, false, 4, 4e-7},
        {ISO_AB4, true, 4, 1.6e-5},         {ISO_SEMI_IMPLICIT, false, 1, 1.3e-2}, {ISO_ABM4, true, 4, 1.4e-6},
        {ISO_ABM4_PEC, true, 4, 1.8e-6},    {ISO_ABM4_PECECE, true, 4, 1.3e-6},    {ISO_BDF4, true, 4, 1.3e-5},
        {ISO_ROSENBROCK, false, 3, 1.5e-5},
    };
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        test_method(&methods[i], alternating, "a sign that changes every tick");
        test_method(&methods[i], noise, "a random sign every tick");
        test_method(&methods[i], zeno, "Zeno's jumps");
    }
    return report_done();
}
