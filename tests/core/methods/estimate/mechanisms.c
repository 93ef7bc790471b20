/* What a checked method says of its local error, over what that error is, in the steps of a plant of any size, whose
 * states are put right after each step: 0.2 to 5 in at least 98 of 100 steps, and half of them on either side of 0.8 to
 * 1.25.
 *
 *     mechanisms SECONDS PARTS METHOD... [-- CONTROL...]
 *
 * with PARTS steps in a second; a control is not: `unsettled`, rk4 whose estimate does not see what is put right, or
 * `adams_formula`, rk4 with the estimate of the methods of lower order, or a method whose estimate does not hold. The
 * true local error is the distance of what the step made, with what was put right, from the solution through the state
 * before it: rk4 with 16 steps in place of one, wrong by 16^-4 of an error of rk4. It is the largest of all states. In
 * double, with compensated sums; steps are left out whose error may be rounding: 16 epsilons of the largest state,
 * since what is put right is not compensated. An estimate is right to the first order in h, and near a zero of the
 * leading term in all states the next one decides; 2 in 100 steps are for that.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/settled.h"
#include "tests/core/methods/order/settled.h"
#include "tests/host/report.h"

enum { SUBSTEPS = 16, STEPS_MAX = 10000, STATES_MAX = 64, VECTORS_MAX = 12, FACTORS_MAX = 4 * STATES_MAX * STATES_MAX };

static const char *const names[] = ISO_METHOD_NAMES;
static size_t states;
static const real *parameters;

/* A run: the estimate told by each step, and the true error. */
static double estimate[STEPS_MAX + 4], error[STEPS_MAX], ratios[STEPS_MAX];
static real x[STATES_MAX * VECTORS_MAX], work[ISO_PRIME_VECTORS * STATES_MAX], lu[FACTORS_MAX];

static double size_of(const real *const a, const real *const b)
{
    double largest = 0.0;
    for (size_t i = 0; i < states; i++) {
        largest = fmax(largest, fabs((double)(b == NULL ? a[i] : a[i] - b[i])));
    }
    return largest;
}

static void settled_step(const unsigned recipe, const real h, real *const to, iso_progress *const progress)
{
    iso_method_step(recipe, states, the_equations, h, to, NULL, parameters, lu, work, progress);
    if (the_settle != NULL) {
        if (ISO_IS_SETTLED(recipe)) {
            iso_method_settles(recipe, states, the_equations, to, work);
        }
        the_settle(to);
        if (ISO_IS_SETTLED(recipe)) {
            iso_method_settled(recipe, states, the_equations, to, work, progress);
        }
    }
}

/* rk4 checked by the implicit Adams formula of order six. */
static void adams_step(const real h, real *const to, iso_progress *const progress)
{
    const iso_history history = {.n = states,
                                 .x = to,
                                 .check = to + states,
                                 .compensation = to + (1 + ISO_ADAMS_DERIVATIVES) * states,
                                 .checked = ISO_ADAMS_DERIVATIVES - 1};
    iso_step step = {.history = &history,
                     .equations = the_equations,
                     .f = the_equations->derivative,
                     .h = h,
                     .p = parameters,
                     .work = work};
    iso_evaluate(&step, work, to);
    iso_rk4_step(&step);
    progress->local_error = step.error;
}

/* How many steps later the error of a step is told. */
static int delay_of(const unsigned recipe)
{
    return ISO_IS_CENTRED(recipe) ? 2 : ISO_CHECKS_DERIVATIVES(recipe) ? 1 : 0;
}

static void run(const unsigned recipe, const real h, const int steps, const bool by_adams)
{
    iso_any_progress progress = {{.local_error = R(0.0)}};
    memset(x, 0, sizeof x);
    memcpy(x, iso_the_plant.model->start, states * sizeof *x);
    iso_method_prime(recipe, states, the_equations, h, x, NULL, parameters, lu, work, &progress.progress);
    for (int step = 0; step < steps; step++) {
        static real exact[STATES_MAX * 2];
        iso_progress unused = {.local_error = R(0.0)};
        memset(exact, 0, sizeof exact);
        memcpy(exact, x, states * sizeof *x);
        for (int i = 0; i < SUBSTEPS; i++) {
            iso_method_step(ISO_RK4 | ISO_COMPENSATED, states, the_equations, h / SUBSTEPS, exact, NULL, parameters, lu,
                            work, &unused);
            if (the_settle != NULL) {
                the_settle(exact);
            }
        }
        if (by_adams) {
            adams_step(h, x, &progress.progress);
        } else {
            settled_step(recipe, h, x, &progress.progress);
        }
        estimate[step] = (double)progress.progress.local_error;
        error[step] = size_of(x, exact);
        error[step] = error[step] > 16.0 * (double)ISO_REAL_EPSILON * size_of(x, NULL) ? error[step] : 0.0;
    }
}

static int compare(const void *const a, const void *const b)
{
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* Of the steps from the eighth on, where what was primed no longer shows. `behind` is the delay of the estimate. */
static void test_ratios(const char *const name, const int steps, const int behind, const bool expected)
{
    int count = 0, outside = 0;
    for (int step = 8; step + behind < steps; step++) {
        if (error[step] > 0.0) {
            const double ratio = estimate[step + behind] / error[step];
            outside += !(ratio >= 0.2 && ratio <= 5.0);
            ratios[count++] = ratio;
        }
    }
    qsort(ratios, (size_t)count, sizeof *ratios, compare);
    const double median = count > 0 ? ratios[count / 2] : 0.0;
    const bool good = count >= 100 && 100 * outside <= 2 * count && median >= 0.8 && median <= 1.25;
    report_ok(good == expected, "%s%s: of %d steps %d outside of 0.2 to 5; %.3g to %.3g, median %.3g",
              expected ? "" : "control: ", name, count, outside, count > 0 ? ratios[0] : 0.0,
              count > 0 ? ratios[count - 1] : 0.0, median);
}

/* A method by its name, or a control. */
static void test_named(const char *const name, const real h, const int steps, const bool is_control)
{
    const unsigned options = ISO_CHECKED | ISO_COMPENSATED;
    const bool by_adams = strcmp(name, "adams_formula") == 0;
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if (strcmp(names[method], name) == 0) {
            const unsigned recipe = method | options | (the_settle != NULL ? ISO_SETTLED : 0U);
            run(recipe, h, steps, false);
            test_ratios(name, steps, delay_of(recipe), !is_control);
        }
    }
    if (by_adams || strcmp(name, "unsettled") == 0) {
        run(ISO_RK4 | options, h, steps, by_adams);
        test_ratios(name, steps, by_adams ? 1 : delay_of(ISO_RK4 | options), false);
    }
}

int main(const int count, char **const arguments)
{
    const double seconds = count > 2 ? strtod(arguments[1], NULL) : 0.0;
    const double parts = count > 2 ? strtod(arguments[2], NULL) : 1.0;
    const int steps = (int)lround(seconds * parts);
    bool is_control = false;
    states = iso_the_plant.model->states;
    parameters = iso_the_plant.model->defaults;
    if (!report_ok(steps > 0 && steps <= STEPS_MAX && states <= STATES_MAX && the_equations->factors <= FACTORS_MAX,
                   "the plant fits")) {
        return report_done();
    }
    for (int i = 3; i < count; i++) {
        if (strcmp(arguments[i], "--") == 0) {
            is_control = true;
        } else {
            test_named(arguments[i], (real)(1.0 / parts), steps, is_control);
        }
    }
    return report_done();
}
