/* What a checked method says of its local error, over what that error is, in every step of the first 5 s of the double
 * pendulum: 0.2 to 5.
 *
 * The true local error of a step is the distance of its increment from that of the solution through the state before
 * it: rk4 with 64 steps in place of one, wrong by 64^-4 of an error of rk4. Of a state alone it passes through zero
 * many times a second; the largest of all states, which is what a method tells, does not. A multistep method makes the
 * step from its own history: for bdf4 that is the error constant over sigma(1), 1/5 h^5 x^(5) (Hairer, Norsett, Wanner
 * 1993, III.2). Sums are compensated, so that errors far below the ulp of the state are seen. The first quarter of a
 * second is left out: at rest with both arms horizontal odd derivatives vanish, and the leading term of the error with
 * them.
 *
 * Estimates are right to the first order in h, and where the leading term is small the next ones decide: h must resolve
 * the motion. In double it does with 2^-10 s, a millisecond. In float a method has a step with which it holds in double
 * too, and the steps are compared whose error is more than rounding. Of rk4, abm4 and abm4_pecece there are three at
 * most: where steps are long enough to be seen in float, they no longer resolve the motion.
 */
#include <math.h>

#include "tests/core/methods/estimate/local_error.h"
#include "tests/core/methods/order/order.h"
#include "tests/general.h"
#include "tests/host/report.h"
#include "tests/one_step.h"

enum {
    SECONDS = 5,
    PER_SECOND_MAX = 10, /* h = 2^-this s at least */
    STEPS_MAX = SECONDS << PER_SECOND_MAX,
    FACTORS_MAX = STATES * STATES,
    STATE_MAX = ISO_METHOD_STATE(ISO_AB4 | ISO_CHECKED | ISO_COMPENSATED, STATES),
};

static const char *const names[] = ISO_METHOD_NAMES;

/* h = 2^-k s of each method; 0: none. */
#ifdef ISO_REAL_DOUBLE
#define REAL_TEXT "double"
#define EVERY(r, constant, ...) [constant] = PER_SECOND_MAX,
static const int step_of[] = {ISO_METHOD_LIST(EVERY, 0)};
#else
#define REAL_TEXT "float"
static const int step_of[ISO_METHODS] = {
    [ISO_EULER] = 10,   [ISO_SEMI_IMPLICIT] = 10, [ISO_HEUN] = 8,       [ISO_AB4] = 7,
    [ISO_ABM4_PEC] = 8, [ISO_BDF4] = 8,           [ISO_ROSENBROCK] = 8,
};
#endif

/* A run: estimate and true error, step by step. */
static double estimate[STEPS_MAX + 1];
static local_error error[STEPS_MAX];
static const double alike[STATES] = {1.0, 1.0, 1.0, 1.0};
static ratios found;

static void start(real x[STATES])
{
    for (int i = 0; i < STATES; i++) {
        x[i] = (real)the_problem.start[i];
    }
}

static void run(const unsigned method, const int per_second)
{
    const unsigned recipe = method | ISO_CHECKED | ISO_COMPENSATED;
    const real h = (real)ldexp(1.0, -per_second);
    real x[STATE_MAX] = {R(0.0)}, work[ISO_PRIME_VECTORS * STATES], lu[FACTORS_MAX];
    const real *const compensation = iso_history_of(recipe, STATES, x).compensation;
    iso_any_progress progress = {{.local_error = R(0.0)}};
    watch w;
    start(x);
    general_prime(recipe, STATES, the_equations, h, x, NULL, NULL, lu, work, &progress.progress);
    for (int step = 0; step < SECONDS << per_second; step++) {
        before_step(&w, x, compensation, h);
        general_step(recipe, STATES, the_equations, h, x, NULL, NULL, lu, work, &progress.progress);
        error[step] = after_step(&w, x, compensation, alike);
        estimate[step] = (double)progress.progress.local_error;
    }
}

/* Those of all steps after a quarter of a second. The estimate of a step stands `behind` steps later. */
static void find_ratios(const int per_second, const int behind)
{
    found.count = 0;
    found.unseen = 0;
    for (int step = (1 << per_second) / 4; step + behind < SECONDS << per_second; step++) {
        ratios_add(&found, estimate[step + behind], error[step]);
    }
    ratios_sort(&found);
}

static void test_method(const unsigned method, const int per_second)
{
    run(method, per_second);
    const unsigned recipe = method | ISO_CHECKED;
    find_ratios(per_second, ISO_IS_CENTRED(recipe) ? 2 : ISO_CHECKS_DERIVATIVES(recipe) ? 1 : 0);
    report_ok(ratios_within(&found),
              "%s in " REAL_TEXT ", h = 2^-%d s: estimate / error in %d of %d steps: %.3f to %.3f, median %.3f",
              names[method], per_second, found.count, found.count + found.unseen, ratios_least(&found),
              ratios_most(&found), ratios_median(&found));
}

/* Positive control: a method whose check has too few derivatives. */
static void test_few_derivatives(const iso_tableau *const table, const uint8_t checked, const char *const name)
{
    enum { PER_SECOND = 10 };
    const real h = (real)ldexp(1.0, -PER_SECOND);
    real x[STATES], compensation[STATES] = {R(0.0)}, check[ISO_ADAMS_DERIVATIVES * STATES] = {R(0.0)};
    real work[ISO_EXPLICIT_VECTORS * STATES];
    const iso_history history = {.n = STATES, .x = x, .check = check, .compensation = compensation, .checked = checked};
    watch w;
    start(x);
    for (int step = 0; step < SECONDS << PER_SECOND; step++) {
        before_step(&w, x, compensation, h);
        estimate[step] = (double)one_explicit_step(table, &history, the_equations->derivative, h, NULL, NULL, work);
        error[step] = after_step(&w, x, compensation, alike);
    }
    find_ratios(PER_SECOND, 1);
    report_ok(!ratios_within(&found), "control: %s: %.3g to %.3g, median %.3g", name, ratios_least(&found),
              ratios_most(&found), ratios_median(&found));
}

int main(void)
{
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if (step_of[method] > 0 && !ISO_IS_VARYING(method)) {
            test_method(method, step_of[method]);
        }
    }
    test_few_derivatives(&iso_tableau_heun, 1, "heun checked with one derivative before the end of the step");
    if (step_of[ISO_RK4] > 0) {
        test_few_derivatives(&iso_tableau_rk4, 4, "rk4 checked with four derivatives");
    }
    return report_done();
}
