/* The order of every method on a plant whose inputs change at every tick, in both readings of an input, at 1 s, in
 * double.
 *
 * Held: the input is a staircase. The reference is the exact solution with the staircase of the same ticks. A method
 * without a history has its order. One with a history is exact to its order for another signal, a continuous one that
 * is h/2 ahead (bdf4: h/2 behind): so its order is one.
 *
 * Smooth: the input is a sample of a continuous signal. The reference is the exact solution with that signal. Every
 * method has its order; in the reading `held`, order one, as the staircase is h/2 late.
 *
 * The signals are at rest at the start to the fourth derivative, as before it, so that the first steps have a past.
 * The references are rk4 with the exact inputs of each stage and 2^-14 s; their difference to 2^-13 s tells their
 * error.
 *
 * The steps of adams vary, with a tolerance of 1e-13; what is left is that of the extrapolation over a tick.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/general.h"
#include "tests/host/report.h"
#include "tests/isoc/plant/inputs/inputs.h"

enum { STATES = 4, INPUTS = 2, VECTORS = 12, FACTORS = 64, FINEST = 14, HALVINGS = 2 };

/* The accepted distance of an observed order from the method's: with C h^p (1 + D h) it is D h / (2 ln 2) with the
 * coarser step. Extrapolation has D up to 80 / s. */
#define ORDER_TOLERANCE 0.12

/* h = 2^-this s at first: D h / (2 ln 2) is small there, and the last errors are far above rounding, some 1e-13. */
static int coarsest_of(const unsigned recipe)
{
    return ISO_ORDER_OF(recipe) == 1 || ISO_IS(recipe, ISO_ABM4_PEC) ? 10 : ISO_IS_SMOOTH(recipe) ? 9 : 7;
}

#define PI 3.14159265358979323846

static const char *const names[] = ISO_METHOD_NAMES;

typedef void signal_of(double u[INPUTS], double t);

static void continuous(double u[INPUTS], const double t)
{
    const double soft = sin(PI * t) * sin(PI * t) * sin(PI * t) * sin(PI * t);
    u[0] = 8.0 * soft * sin(4.0 * PI * t + 1.0);
    u[1] = 1.5 * soft * cos(3.0 * PI * t);
}

static double tick; /* s */

static void staircase(double u[INPUTS], const double t)
{
    continuous(u, tick * floor(t / tick));
}

/* One step of rk4 with the inputs of each stage; of a staircase with those of its middle. */
static void exact_step(double x[STATES], signal_of *const signal, const double t, const double h)
{
    static const double c[] = {0.0, 0.5, 0.5, 1.0}, b[] = {1.0, 2.0, 2.0, 1.0};
    double sum[STATES] = {0.0}, k[STATES] = {0.0}, at[STATES], u[INPUTS];
    for (int i = 0; i < 4; i++) {
        signal(u, t + h * (signal == staircase ? 0.5 : c[i]));
        for (int s = 0; s < STATES; s++) {
            at[s] = x[s] + h * c[i] * k[s];
        }
        the_equations->derivative(k, at, u, iso_the_plant.model->defaults);
        for (int s = 0; s < STATES; s++) {
            sum[s] += h / 6.0 * b[i] * k[s];
        }
    }
    for (int s = 0; s < STATES; s++) {
        x[s] += sum[s];
    }
}

static void exact(double x[STATES], signal_of *const signal, const double from, const double to, const int finest)
{
    const double h = ldexp(1.0, -finest);
    for (long i = lround(from / h); i < lround(to / h); i++) {
        exact_step(x, signal, (double)i * h, h);
    }
}

static double distance(const double *const a, const double *const b)
{
    double square = 0.0;
    for (int s = 0; s < STATES; s++) {
        square += (a[s] - b[s]) * (a[s] - b[s]);
    }
    return sqrt(square);
}

/* A plant that runs with any method. */
typedef struct running {
    unsigned recipe;
    iso_equations equations;
    real h;
    real x[STATES * VECTORS], u[6 * INPUTS + 1], work[(ISO_PRIME_VECTORS + 2) * STATES + INPUTS], lu[FACTORS];
    iso_any_progress progress;
} running;

static const iso_adams_options fine = {
    .tolerance_absolute = R(1e-13),
    .tolerance_relative = R(1e-13),
    .budget = ISO_ADAMS_BUDGET_HOST,
    .driven = true,
    .level_max = ISO_ADAMS_LEVELS,
};

static void start(running *const r, const unsigned recipe, const real h)
{
    memset(r, 0, sizeof *r);
    r->recipe = recipe;
    r->equations = *the_equations;
    r->equations.adams = &fine;
    r->h = h;
    memcpy(r->x, iso_the_plant.model->start, STATES * sizeof *r->x);
    iso_method_forget(recipe, &r->equations, r->u);
    general_prime(recipe, STATES, &r->equations, h, r->x, r->u, iso_the_plant.model->defaults, r->lu, r->work,
                  &r->progress.progress);
}

static void step(running *const r, const double t)
{
    continuous(r->u, t);
    iso_method_sample(r->recipe, &r->equations, r->u);
    general_step(r->recipe, STATES, &r->equations, r->h, r->x, r->u, iso_the_plant.model->defaults, r->lu, r->work,
                 &r->progress.progress);
}

/* The error at 1 s with steps of 2^-k s. */
static double error_of(const unsigned recipe, const int k, signal_of *const signal)
{
    static running r;
    double wanted[STATES];
    tick = ldexp(1.0, -k);
    memcpy(wanted, iso_the_plant.model->start, sizeof wanted);
    exact(wanted, signal, 0.0, 1.0, FINEST);
    start(&r, recipe, (real)tick);
    for (long i = 0; i < 1L << k; i++) {
        step(&r, (double)i * tick);
    }
    return distance(r.x, wanted);
}

/* The largest local error of a step from a second on, as a method tells it and as it is, over its state from before. */
static void local_errors(const unsigned recipe, const int k, double *const told, double *const is)
{
    static running r;
    tick = ldexp(1.0, -k);
    start(&r, recipe, (real)tick);
    *told = *is = 0.0;
    for (long i = 0; i < 1L << k; i++) {
        double wanted[STATES];
        memcpy(wanted, r.x, sizeof wanted);
        exact(wanted, continuous, (double)i * tick, (double)(i + 1) * tick, k + 4);
        step(&r, (double)i * tick);
        for (int s = 0; s < STATES && i > 1L << (k - 2); s++) {
            *is = fmax(*is, fabs(r.x[s] - wanted[s]));
            *told = fmax(*told, r.progress.progress.local_error);
        }
    }
}

/* Whether the order at 1 s is `order`; prints it. */
static bool has_order(const unsigned recipe, signal_of *const signal, const char *const reading, const int order)
{
    const int coarsest = coarsest_of(recipe), halvings = ISO_IS_VARYING(recipe) ? 1 : HALVINGS;
    double coarse = error_of(recipe, coarsest, signal), observed = 0.0;
    bool all = true;
    for (int k = coarsest + 1; k <= coarsest + halvings; k++) {
        const double error = error_of(recipe, k, signal);
        observed = log2(coarse / error);
        all = all && fabs(observed - order) <= ORDER_TOLERANCE;
        report_note("%s, %s, 2^-%d s: error %.3e, order %.3f", names[ISO_METHOD_OF(recipe)], reading, k, error,
                    observed);
        coarse = error;
    }
    return all;
}

static bool has_history(const unsigned recipe)
{
    return ISO_PAST_KEPT(recipe) > 0;
}

static void test_orders(void)
{
    for (unsigned i = 0; i < ISO_METHODS; i++) {
        const int order = ISO_ORDER_OF(i), held = has_history(i) ? 1 : order;
        if (!ISO_IS_VARYING(i)) {
            report_ok(has_order(i, staircase, "held", held), "%s, held: order %d", names[i], held);
        }
        report_ok(has_order(i | ISO_SMOOTH, continuous, "smooth", order), "%s, smooth: order %d", names[i], order);
    }
    report_ok(has_order(ISO_RK4, continuous, "held", 1), "control: rk4, held, against the continuous signal: order 1");
}

static void test_local_errors(void)
{
    for (unsigned i = 0; i < ISO_METHODS; i++) {
        double told, is;
        local_errors(i | ISO_SMOOTH | ISO_CHECKED, 9, &told, &is);
        const bool tells = told > 0.8 * is && told < 1.25 * is;
        if (ISO_TELLS_NO_INPUTS(i)) {
            report_ok(!tells, "control: %s, of which isoc warns: local error %.2e, told as %.2e", names[i], is, told);
        } else {
            report_ok(tells, "%s: local error %.2e, told as %.2e", names[i], is, told);
        }
    }
}

int main(const int count, char **const arguments)
{
    if (count > 1) {
        const int order = has_order(ISO_ROSENBROCK | ISO_SMOOTH, continuous, arguments[1], 3) ? 3 : 0;
        report_ok(order == 3, "rosenbrock, smooth, %s: order 3", arguments[1]);
        return report_done();
    }
    double whole[STATES], half[STATES];
    memcpy(whole, iso_the_plant.model->start, sizeof whole);
    memcpy(half, whole, sizeof half);
    exact(whole, continuous, 0.0, 1.0, FINEST);
    exact(half, continuous, 0.0, 1.0, FINEST - 1);
    report_ok(distance(whole, half) <= 15e-13, "the reference: off by %.1e", distance(whole, half) / 15.0);
    test_orders();
    test_local_errors();
    return report_done();
}
