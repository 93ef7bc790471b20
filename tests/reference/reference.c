/* A plant against reference solutions: rk4, 1 ms, double. Linked with the plant and one set of references.
 *
 * The error at time t must be within FACTOR of the truncation error, which halving the step measures: for order four,
 * y_h - y = (16 / 15) (y_h - y_{h/2}) but for terms of higher order (Richardson 1911). Errors are 2-norms over the
 * states, rad and rad/s.
 */
#include <math.h>
#include <string.h>

#include "core/methods/rk4.h"
#include "core/runtime/plant.h"
#include "tests/host/report.h"
#include "tests/one_step.h"
#include "tests/reference/reference.h"

#define FACTOR 3.0
#define MS 0.001
#define ROUNDING 1e-12 /* 1000 steps of half an epsilon of some 20 rad/s each, were all in one direction */

typedef struct state {
    double x[REFERENCE_STATES_MAX];
} state;

static double distance(const double *const a, const double *const b)
{
    double square = 0.0;
    for (int i = 0; i < the_reference.states; i++) {
        square += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sqrt(square);
}

/* |x - y| with y in long double: the reference is not rounded before the difference. */
static double error_of(const double *const x, const long double *const y)
{
    double square = 0.0;
    for (int i = 0; i < the_reference.states; i++) {
        const double e = (double)((long double)x[i] - y[i]);
        square += e * e;
    }
    return sqrt(square);
}

/* The plant's state of the reference's coordinates. */
static state rounded(const long double *const y)
{
    long double x[REFERENCE_STATES_MAX] = {0.0L};
    state s;
    the_reference.to_plant(x, y);
    for (int i = 0; i < REFERENCE_STATES_MAX; i++) {
        s.x[i] = (double)x[i];
    }
    return s;
}

/* Advances s by ms milliseconds, by the plant's own steps. */
static void run(state *const s, const int ms)
{
    const size_t bytes = (size_t)the_reference.states * sizeof(double);
    memcpy(iso_the_plant.x, s->x, bytes);
    iso_the_plant.model->output(iso_the_plant.memory);
    for (int n = 0; n < ms; n++) {
        iso_the_plant.model->step(iso_the_plant.memory);
    }
    memcpy(s->x, iso_the_plant.x, bytes);
}

/* By the method with the plant's derivative. */
static void run_method(state *const s, const int ms, const int steps_per_ms)
{
    double work[ISO_EXPLICIT_VECTORS * REFERENCE_STATES_MAX];
    const iso_history history = {.n = (size_t)the_reference.states, .x = s->x};
    for (long n = 0; n < (long)ms * steps_per_ms; n++) {
        (void)one_explicit_step(&iso_tableau_rk4, &history, iso_the_derivative, MS / steps_per_ms, iso_the_plant.u,
                                iso_the_plant.p, work);
    }
}

static void test_case(const reference_case *const c)
{
    state whole = rounded(c->start);
    state half = whole;
    bool seen = true;
    int at = 0;
    for (int r = 0; r < c->rows; r++) {
        long double exact[REFERENCE_STATES_MAX];
        run(&whole, c->row[r].ms - at);
        run_method(&half, c->row[r].ms - at, 2);
        at = c->row[r].ms;
        the_reference.to_plant(exact, c->row[r].y);
        const double error = error_of(whole.x, exact);
        const double truncation = distance(whole.x, half.x) * 16.0 / 15.0;
        report_ok(error <= FACTOR * truncation, "%s, t = %g s: error %.3e = %.2f x truncation; at most %.0e", c->name,
                  at * MS, error, error / truncation, FACTOR * truncation);
        exact[0] *= 1.0L + 1e-6L;
        seen = seen && error_of(whole.x, exact) > FACTOR * truncation;
    }
    report_ok(seen, "control: %s, a reference off by 1e-6 is seen at every time", c->name);
}

/* The plant's own step is the method with its derivative, but for rounding: its stages may take sines from those of the
 * start (core/methods/explicit.h). */
static void test_step(void)
{
    state method = rounded(the_reference.first->start), own = method, halves = method;
    report_ok(memcmp(iso_the_plant.model->start, own.x, (size_t)the_reference.states * sizeof(double)) == 0,
              "the scene starts where the reference does");
    run_method(&method, 1000, 1);
    run(&own, 1000);
    const double apart = distance(own.x, method.x);
    report_ok(apart <= ROUNDING, "a second of the plant's own steps: the method's to %.1e", apart);
    run_method(&halves, 1000, 2);
    report_ok(distance(own.x, halves.x) > ROUNDING, "control: steps in two halves are seen");
}

int main(void)
{
    if (!report_ok(iso_the_plant.model->states == the_reference.states &&
                       strcmp(iso_the_plant.model->method, "rk4") == 0 && iso_the_plant.model->period_ns == 1000000,
                   "the plant has the reference's states, rk4 and 1 ms")) {
        return report_done();
    }
    for (int i = 0; i < the_reference.cases; i++) {
        test_case(&the_reference.first[i]);
    }
    test_step();
    return report_done();
}
