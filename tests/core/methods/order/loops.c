/* The observed order of every method on a closed loop, with the stabilisation that a scene has by itself: halving h
 * divides the errors by 2^order. In double, with compensated sums. What a plant puts right after a step is no part of
 * the method, and does not depend on h.
 *
 *     loops TIME COARSEST [OUTPUT VALUE]...
 *
 * TIME is in s, the first step is 2^-COARSEST s. An error is the root of the sum of squares over all states at POINTS
 * times, the last of them TIME. The solution is rk4's with a quarter of the finest step; at its end each OUTPUT, by its
 * place, is VALUE to a part in 1e9: a reference that is not ours. Errors are C h^p (1 + D h + ...), so that log2(e(h) /
 * e(h / 2)) is p + D h / (2 ln 2) + ...: the first step makes the second term less than the tolerance. Errors of which
 * rounding may be a twentieth show no order: rounding is 2^-53 times the root of the steps, times 10 for the growth of
 * an error and the size of the states.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/core/methods/order/settled.h"
#include "tests/host/report.h"

enum { HALVINGS = 2, POINTS = 8, STATES_MAX = 40, VECTORS_MAX = 10, FACTORS_MAX = 3 * STATES_MAX * STATES_MAX };

static const double order_tolerance = 0.1;
static const char *const names[] = ISO_METHOD_NAMES;
static size_t states;
static const real inputs[1]; /* zeros */

typedef real motion[POINTS][STATES_MAX];

/* The states with steps of 2^-k s. */
static void run(const unsigned recipe, const int k, const double time, motion to)
{
    static real x[STATES_MAX * VECTORS_MAX], work[ISO_PRIME_VECTORS * STATES_MAX], lu[FACTORS_MAX];
    const real h = (real)ldexp(1.0, -k);
    const long steps = lround(ldexp(time, k) / POINTS);
    iso_any_progress progress = {{.local_error = R(0.0)}};
    memset(x, 0, sizeof x);
    memcpy(x, iso_the_plant.model->start, states * sizeof *x);
    iso_method_prime(recipe, states, the_equations, h, x, inputs, NULL, lu, work, &progress.progress);
    for (int point = 0; point < POINTS; point++) {
        for (long step = 0; step < steps; step++) {
            iso_method_step(recipe, states, the_equations, h, x, inputs, NULL, lu, work, &progress.progress);
            the_settle(x);
        }
        memcpy(to[point], x, states * sizeof *x);
    }
}

static double distance(motion a, motion b)
{
    double square = 0.0;
    for (int point = 0; point < POINTS; point++) {
        for (size_t i = 0; i < states; i++) {
            const double apart = (double)a[point][i] - (double)b[point][i];
            square += apart * apart;
        }
    }
    return sqrt(square);
}

static void test_order(const unsigned method, const double time, const int coarsest, motion solution)
{
    const unsigned recipe = method | ISO_COMPENSATED;
    double error[HALVINGS + 1], order = 0.0;
    bool passed = true;
    int seen = 0;
    for (int i = 0; i <= HALVINGS; i++) {
        static motion found;
        run(recipe, coarsest + i, time, found);
        error[i] = distance(found, solution);
        if (i > 0 && error[i] > 20.0 * 10.0 * 0x1p-53 * sqrt(ldexp(time, coarsest + i))) {
            order = log2(error[i - 1] / error[i]);
            passed = passed && fabs(order - ISO_ORDER_OF(recipe)) <= order_tolerance;
            seen++;
        }
    }
    report_ok(passed && seen > 0, "%s has order %d: errors %.2e, %.2e, %.2e, the last order %.3f", names[method],
              ISO_ORDER_OF(recipe), error[0], error[1], error[2], order);
}

int main(const int count, char **const arguments)
{
    static motion solution;
    const double time = count > 1 ? strtod(arguments[1], NULL) : 0.0;
    const int coarsest = count > 2 ? (int)strtol(arguments[2], NULL, 10) : 0, finest = coarsest + HALVINGS + 2;
    const iso_plant *const plant = &iso_the_plant;
    states = plant->model->states;
    if (!report_ok(time > 0.0 && coarsest > 0 && states <= STATES_MAX && plant->model->inputs <= 1 &&
                       the_equations->factors <= FACTORS_MAX,
                   "the plant fits")) {
        return report_done();
    }
    run(ISO_RK4 | ISO_COMPENSATED, finest, time, solution);
    memcpy(plant->x, solution[POINTS - 1], states * sizeof(real));
    plant->model->output(plant->memory);
    for (int i = 3; i + 1 < count; i += 2) {
        const double known = strtod(arguments[i + 1], NULL);
        const double found = (double)plant->y[strtol(arguments[i], NULL, 10)];
        report_ok(fabs(found - known) <= 1e-9 * fabs(known), "output %s is %.13g, %.1e off", arguments[i], found,
                  found - known);
    }
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        /* Semi-implicit Euler needs more where positions are quaternions: tests/core/methods/order/turning.c. */
        if (!ISO_IS_VARYING(method) && (!ISO_IS(method, ISO_SEMI_IMPLICIT) || states % 2 == 0)) {
            test_order(method, time, coarsest, solution);
        }
    }
    return report_done();
}
