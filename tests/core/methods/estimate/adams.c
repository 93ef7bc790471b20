/* What adams says of its local error, over what that error is, in every sub-step and in every tick of runs of the
 * double pendulum, from the first sub-step on: 0.2 to 5. Of a sub-step it is the norm that its steps are chosen by, the
 * largest of all states over what it may err; of a tick it is the local error that the method tells.
 *
 * Runs begin in the midst of the motion, a quarter of a second and more after its start from rest, where the errors of
 * odd order are zero. The true error is that of tests/core/methods/estimate/local_error.h. As with a fixed step
 * (tests/core/methods/estimate/estimate.c) an estimate is right to the first order in h, and one in the middle of all
 * is wrong by about the square of it. In double every error is more than rounding but those of a start, whose steps are
 * for order one. Steps for a tolerance of 1e-6, the method's own, resolve the motion; those for 1e-5 do not always, and
 * their estimates neither.
 */
#include <math.h>

#include "tests/core/methods/adaptive/run.h"
#include "tests/core/methods/estimate/local_error.h"
#include "tests/core/methods/order/order.h"
#include "tests/host/report.h"

enum { SECONDS = 5, STARTS = 4 };

/* A median may be off one by this: in units of the motion 19/720 h^5 is 1e-6 where h^2 is 0.017, thrice. */
#define ACCURACY 0.05

static ratios of_substeps;
static ratios of_ticks;

/* What is done to the constants of a control. */
typedef enum change { NOTHING, OTHER_CONSTANT, ROWS_ONLY_SCALED } change;

/* The changes of order and step after a sub-step, without what the last correction says of the past: rows are scaled,
 * and nothing else (Nordsieck 1962). */
static void adapt_rows_only(iso_adams_run *const run, const iso_adams_estimates estimates)
{
    real last[STATES];
    real *const kept = iso_adams_last(run->history);
    const uint8_t level = run->state->level;
    const uint8_t order = run->state->order;
    memcpy(last, kept, sizeof last);
    memset(kept, 0, sizeof last);
    iso_adams_adapt(run, estimates);
    for (int i = 0; i < STATES && run->state->order == order; i++) {
        kept[i] = last[i] * (real)(run->state->level < level ? 2 << order : 1);
    }
}

/* A sub-step like iso_adams_attempt, with the adaptation above. */
static void attempt_rows_only(iso_adams_run *const run)
{
    if (run->state->starting) {
        iso_adams_attempt(run);
        return;
    }
    run->left--;
    const real estimate = iso_adams_try(run);
    if (estimate > R(1.0) && iso_adams_reject(run, estimate)) {
        run->refused = estimate;
    } else {
        const iso_adams_estimates estimates = iso_adams_correct(run);
        run->refused = R(0.0);
        run->remaining--;
        run->state->substeps++;
        adapt_rows_only(run, estimates);
    }
}

/* One sub-step, and what it says of its error; of a control, with a leading constant of 1/24 in place of 19/720. */
static void try_substep(iso_adams_run *const run, const real *const compensation, const real tolerance,
                        const change made)
{
    const uint32_t substeps = run->state->substeps;
    const real *const x = run->history->x;
    real before[STATES];
    double weight[STATES];
    double estimate = 0.0;
    watch w;
    before_step(&w, x, compensation, iso_adams_step_size(run));
    for (int i = 0; i < STATES; i++) {
        before[i] = run->error[i];
    }
    if (made == ROWS_ONLY_SCALED) {
        attempt_rows_only(run);
    } else {
        iso_adams_attempt(run);
    }
    for (int i = 0; i < STATES; i++) {
        weight[i] = 1.0 / ((double)tolerance * (1.0 + fabs((double)w.x[i])));
        estimate = fmax(estimate, weight[i] * fabs((double)(run->error[i] - before[i])));
    }
    if (run->state->substeps > substeps) {
        estimate *= made == OTHER_CONSTANT ? (1.0 / 24.0) / (19.0 / 720.0) : 1.0;
        ratios_add(&of_substeps, estimate, after_step(&w, x, compensation, weight));
    }
}

/* A run that begins so many quarters of a second after the motion's. Returns the sub-steps that were halved. */
static uint32_t run_from(const int quarters, const real h, const real tolerance, const change made)
{
    static const double alike[STATES] = {1.0, 1.0, 1.0, 1.0};
    real x[STATES], compensation[STATES] = {R(0.0)};
    adams_memory m;
    for (int i = 0; i < STATES; i++) {
        x[i] = (real)the_problem.start[i];
    }
    solution(x, R(1.0) / R(1024.0), 256 * quarters);
    adams_prepare(&m, STATES, x, tolerance, ISO_ADAMS_BUDGET_HOST);
    m.history.compensation = compensation;
    adams_begin(&m, the_equations->derivative, h, NULL);
    for (int tick = 0; tick < (int)((real)SECONDS / h); tick++) {
        iso_adams_run run = adams_walk(&m, the_equations->derivative, h);
        double estimate = 0.0;
        watch w;
        before_step(&w, m.x, compensation, h);
        while (run.remaining > 0) {
            try_substep(&run, compensation, tolerance, made);
        }
        for (int i = 0; i < STATES; i++) {
            estimate = fmax(estimate, fabs((double)run.error[i]));
        }
        ratios_add(&of_ticks, estimate, after_step(&w, m.x, compensation, alike));
    }
    return m.state.rejected;
}

/* Fills both lists. Returns the sub-steps that were halved. */
static uint32_t run_all(const real h, const real tolerance, const change made)
{
    uint32_t rejected = 0;
    of_substeps.count = of_substeps.unseen = 0;
    of_ticks.count = of_ticks.unseen = 0;
    for (int start = 1; start <= STARTS; start++) {
        rejected += run_from(start, h, tolerance, made);
    }
    ratios_sort(&of_substeps);
    ratios_sort(&of_ticks);
    return rejected;
}

static bool accurate(const ratios *const r)
{
    return fabs(ratios_median(r) - 1.0) <= ACCURACY;
}

static void say(const bool passed, const char *const what, const ratios *const r)
{
    report_ok(passed, "%s: estimate / error in %d of %d: %.3f to %.3f, median %.3f", what, r->count,
              r->count + r->unseen, ratios_least(r), ratios_most(r), ratios_median(r));
}

static void test_run(const real h, const real tolerance)
{
    const uint32_t rejected = run_all(h, tolerance, NOTHING);
    report_note("tick of %g s, tolerance %g: %d sub-steps halved", (double)h, (double)tolerance, (int)rejected);
    say(ratios_within(&of_substeps) && accurate(&of_substeps), "sub-steps", &of_substeps);
    say(ratios_within(&of_ticks) && accurate(&of_ticks), "ticks", &of_ticks);
}

int main(void)
{
    test_run(R(1.0) / R(64.0), ISO_ADAMS_TOLERANCE);
    test_run(R(1.0) / R(16.0), ISO_ADAMS_TOLERANCE);
#ifdef ISO_REAL_DOUBLE
    test_run(R(1.0) / R(1024.0), ISO_ADAMS_TOLERANCE);
    test_run(R(1.0) / R(64.0), R(1e-8));
#endif
    (void)run_all(R(1.0) / R(64.0), ISO_ADAMS_TOLERANCE, OTHER_CONSTANT);
    say(!accurate(&of_substeps), "control: the constant of order three, sub-steps", &of_substeps);
    (void)run_all(R(1.0) / R(64.0), ISO_ADAMS_TOLERANCE, ROWS_ONLY_SCALED);
    say(!ratios_within(&of_substeps), "control: rows that are only scaled, sub-steps", &of_substeps);
    return report_done();
}
