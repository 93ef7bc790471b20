/* The adams method, whole runs against references: error and cost against the tolerance, a stiff plant with a budget,
 * jumps, and inputs that change from tick to tick. In double. Its estimate of the local error:
 * tests/core/methods/estimate. Stiff plants without a budget: tests/promises/hard.
 */
#include <math.h>

#include "core/methods/all.h"
#include "core/methods/primed.h"
#include "tests/core/methods/adaptive/problems.h"
#include "tests/core/methods/adaptive/run.h"
#include "tests/host/report.h"

enum { N_MAX = PROBLEM_STATES_MAX, TOLERANCES = 7, STEPS_MAX = 1 << 19 };

_Static_assert((int)ADAMS_STATES_MAX >= (int)PROBLEM_STATES_MAX, "a run has room for every problem");

/* The largest difference of two states; infinite where there is none. */
static double distance(const double *const a, const double *const b, const size_t n)
{
    double largest = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double d = fabs(a[i] - b[i]);
        largest = d <= largest ? largest : d;
        if (!isfinite(d)) {
            return HUGE_VAL;
        }
    }
    return largest;
}

/* Runs a problem from what `prepare` left. Returns the error at the end. */
static double run(adams_memory *const m, const problem *const p)
{
    const double h = p->end / p->ticks;
    adams_begin(m, p->f, h, NULL);
    for (int i = 0; i < p->ticks; i++) {
        (void)adams_tick(m, p->f, h, NULL);
    }
    return distance(m->x, p->reference, p->n);
}

static double run_with(adams_memory *const m, const problem *const p, const double tolerance)
{
    adams_prepare(m, p->n, p->start, tolerance, ISO_ADAMS_BUDGET_HOST);
    return run(m, p);
}

static double error_of_abm4(const problem *const p, const long steps)
{
    double x[ISO_METHOD_STATE(ISO_ABM4, N_MAX)];
    double work[ISO_METHOD_PRIME_WORK(ISO_ABM4, N_MAX)];
    const double h = p->end / (double)steps;
    const iso_equations equations = {.derivative = p->f};
    memcpy(x, p->start, p->n * sizeof *x);
    iso_method_prime(ISO_ABM4, p->n, &equations, h, x, NULL, NULL, NULL, work, NULL);
    for (long i = 0; i < steps; i++) {
        iso_method_step(ISO_ABM4, p->n, &equations, h, x, NULL, NULL, NULL, work, NULL);
    }
    return distance(x, p->reference, p->n);
}

/* The evaluations from which on abm4's error is not above this, within 6%: up to twice as many steps are looked at,
 * since the error crosses zero here and there. STEPS_MAX if it takes more. */
static long cost_of_abm4(const problem *const p, const double error)
{
    long least = 16;
    for (long steps = least; steps < 2 * least && steps < STEPS_MAX; steps += 1 + steps / 16) {
        if (error_of_abm4(p, steps) > error) {
            least = steps + 1 + steps / 16;
        }
    }
    return 2 * least;
}

/* The derivative of the line through log(error) over log(tolerance), least squares. */
static double exponent(const double *const errors, const int first, const int count)
{
    double sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
    for (int i = 0; i < count; i++) {
        const double x = -(double)(first + i);
        const double y = log10(errors[i]);
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    return (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
}

/* Every sub-step errs by the tolerance at most, which is for 1 + |x|: the error at the end follows from their sum and
 * from how an error grows on the way. At order four the number of sub-steps goes with tolerance^(-1/5), the error thus
 * with tolerance^(4/5); since steps are powers of two, the errors of two tolerances scatter by up to 2^5 around this:
 * over six decades by log10(32) / 6 = 0.25 in the exponent, if it came to the worst. */
#define EXPONENT 0.8
#define EXPONENT_SCATTER 0.25

static void test_tolerances(const problem *const p)
{
    adams_memory m;
    double errors[TOLERANCES];
    double largest = 0.0;
    bool none_bound = true;
    double size = 1.0;
    for (size_t i = 0; i < p->n; i++) {
        size = fmax(size, 1.0 + fabs(p->reference[i]));
    }
    for (int i = 0; i < TOLERANCES; i++) {
        const double tolerance = pow(10.0, -(p->first_tolerance + i));
        errors[i] = run_with(&m, p, tolerance);
        const double share = errors[i] / (tolerance * size * m.state.substeps);
        largest = fmax(largest, share);
        none_bound = none_bound && m.state.budget_bound == 0;
        report_note("%s, 1e-%d: error %.2e, %.2g of all tolerances; %u sub-steps, %u rejected, %u evaluations", p->name,
                    p->first_tolerance + i, errors[i], share, m.state.substeps, m.state.rejected, m.state.evaluations);
    }
    const double derivative = exponent(errors, p->first_tolerance, TOLERANCES);
    report_ok(largest <= p->share, "%s: the error is at most %g of all tolerances: %.3g", p->name, p->share, largest);
    report_ok(fabs(derivative - EXPONENT) <= EXPONENT_SCATTER, "%s: the error goes with tolerance^%.2f, %.2f +- %.2f",
              p->name, derivative, EXPONENT, EXPONENT_SCATTER);
    report_ok(none_bound, "%s: no sub-step had to be kept", p->name);

    const double blind = run_with(&m, p, HUGE_VAL);
    report_ok(blind > 100.0 * errors[0] || blind > 0.1, "%s, control: without its estimate it misses by %.2e", p->name,
              blind);
}

static void test_cost(const problem *const p)
{
    adams_memory m;
    const double error = run_with(&m, p, 1e-8);
    const long fixed = cost_of_abm4(p, error);
    const double cost = (double)m.state.evaluations / (double)fixed;
    report_ok(cost <= p->cost, "%s: %u evaluations for %.2e; abm4 %ld, a ratio of %.3f", p->name, m.state.evaluations,
              error, fixed, cost);
}

/* At 1 kHz h lambda is -3: eight sub-steps are enough, one is not. */
static void test_stiff_budget(void)
{
    const problem *const p = &problem_bushing;
    adams_memory m;
    adams_prepare(&m, p->n, p->start, ISO_ADAMS_TOLERANCE, ISO_ADAMS_BUDGET);
    double error = run(&m, p);
    report_ok(error <= 1e-5, "%s, budget 8: error %.2e, %u sub-steps, %u kept", p->name, error, m.state.substeps,
              m.state.budget_bound);
    report_ok(m.state.evaluations <= 1 + 16 * (uint32_t)p->ticks, "%s, budget 8: %u evaluations", p->name,
              m.state.evaluations);
    adams_prepare(&m, p->n, p->start, ISO_ADAMS_TOLERANCE, 1);
    error = run(&m, p);
    report_ok(!(error <= 1.0), "%s, control: a budget of 1 ends at %.2e", p->name, error);
    report_ok(m.state.budget_bound > 0, "%s, control: and says so: %u kept", p->name, m.state.budget_bound);
}

/* q' = v, v' = u - q: exact between ticks, where u is held. */
static void swing(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)p;
    dx[0] = x[1];
    dx[1] = u[0] - x[0];
}

static void swing_exactly(double x[2], const double u, const double h)
{
    const double q = x[0] - u;
    const double v = x[1];
    x[0] = u + q * cos(h) + v * sin(h);
    x[1] = v * cos(h) - q * sin(h);
}

/* A step of the input at a tick: found by the estimate, and nothing lost. */
static void test_step_input(const bool driven)
{
    enum { TICKS = 400, PERIOD = 100 };
    const char *const how = driven ? "step input, driven" : "step input";
    const double h = 1.0 / 32.0;
    double exact[2] = {1.0, 0.0};
    double u[1] = {0.0};
    double largest = 0.0;
    uint32_t dearest = 0;
    adams_memory m;
    adams_prepare(&m, 2, exact, 1e-8, ISO_ADAMS_BUDGET_HOST);
    m.options.driven = driven;
    adams_begin(&m, swing, h, u);
    for (int i = 0; i < TICKS; i++) {
        const uint32_t before = m.state.evaluations;
        u[0] = i / PERIOD % 2 == 0 ? 0.0 : 1.0;
        (void)adams_tick(&m, swing, h, u);
        swing_exactly(exact, u[0], h);
        largest = fmax(largest, distance(m.x, exact, 2));
        dearest = m.state.evaluations - before > dearest ? m.state.evaluations - before : dearest;
    }
    report_note("%s: %u sub-steps, %u rejected, %u evaluations, at most %u in a tick", how, m.state.substeps,
                m.state.rejected, m.state.evaluations, dearest);
    report_ok(largest <= 1e-8 * m.state.substeps, "%s: error %.2e", how, largest);
    if (driven) {
        report_ok(m.state.restarts == 0, "%s: no restart is needed", how);
    } else {
        report_ok(m.state.restarts == TICKS / PERIOD - 1, "%s: every jump is found, and restarts once: %u", how,
                  m.state.restarts);
    }
}

/* An input that changes at every tick: with the derivative taken anew there is no restart, and far less to do. */
static uint32_t cost_of_sampled(const bool driven, double *const largest)
{
    enum { TICKS = 1000 };
    const double h = 1.0 / 128.0;
    double exact[2] = {1.0, 0.0};
    double u[1] = {0.0};
    adams_memory m;
    adams_prepare(&m, 2, exact, 1e-8, ISO_ADAMS_BUDGET_HOST);
    m.options.driven = driven;
    *largest = 0.0;
    adams_begin(&m, swing, h, u);
    for (int i = 0; i < TICKS; i++) {
        u[0] = sin(3.0 * i * h);
        (void)adams_tick(&m, swing, h, u);
        swing_exactly(exact, u[0], h);
        *largest = fmax(*largest, distance(m.x, exact, 2));
    }
    report_note("sampled input%s: %u sub-steps, %u rejected, %u restarts, %u evaluations, error %.2e",
                driven ? ", driven" : "", m.state.substeps, m.state.rejected, m.state.restarts, m.state.evaluations,
                *largest);
    return m.state.evaluations;
}

static void test_sampled_input(void)
{
    double error;
    const uint32_t blind = cost_of_sampled(false, &error);
    const uint32_t driven = cost_of_sampled(true, &error);
    report_ok(error <= 1e-5, "sampled input: error %.2e", error);
    report_ok(driven * 2 <= blind, "sampled input: %u evaluations with the derivative taken at every tick, %u without",
              driven, blind);
}

/* q' = v, v' = -sign q: the derivative jumps within a tick; from q = 1/2 the period is 4 s. A jump that lies ahead is
 * found again after each restart, a step or two before it, until a step passes it with an error below the tolerance. */
static void bang(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = x[0] > 0.0 ? -1.0 : 1.0;
}

static void test_switch(void)
{
    enum { PERIODS = 10 };
    static const double start[2] = {0.5, 0.0};
    const double h = 0.3125; /* 4 s are 12.8 ticks, 20 s are 64 */
    adams_memory m;
    adams_prepare(&m, 2, start, 1e-8, ISO_ADAMS_BUDGET_HOST);
    adams_begin(&m, bang, h, NULL);
    for (int i = 0; i < 128; i++) {
        (void)adams_tick(&m, bang, h, NULL);
    }
    const double error = distance(m.x, start, 2);
    report_note("switch: %u sub-steps, %u rejected, %u restarts, %u kept, %u evaluations", m.state.substeps,
                m.state.rejected, m.state.restarts, m.state.budget_bound, m.state.evaluations);
    report_ok(error <= 1e-8 * m.state.substeps, "switch: error %.2e after %d periods", error, PERIODS);
    report_ok(m.state.restarts >= 2 * PERIODS && m.state.restarts <= 8 * 2 * PERIODS,
              "switch: %u restarts for %d jumps", m.state.restarts, 2 * PERIODS);
}

/* The double pendulum at 1 kHz, as on a target. */
static void test_real_time(void)
{
    problem p = problems[1];
    adams_memory m;
    p.ticks = 5000;
    adams_prepare(&m, p.n, p.start, ISO_ADAMS_TOLERANCE, ISO_ADAMS_BUDGET);
    const double error = run(&m, &p);
    report_ok(error <= 1e-6, "1 kHz, budget 8: error %.2e", error);
    report_ok(m.state.budget_bound == 0, "1 kHz, budget 8: it does not bind");
    report_ok(m.state.substeps <= 5100, "1 kHz, budget 8: %u sub-steps, %u rejected", m.state.substeps,
              m.state.rejected);
}

int main(void)
{
    for (size_t i = 0; i < PROBLEMS; i++) {
        test_tolerances(&problems[i]);
        test_cost(&problems[i]);
    }
    test_stiff_budget();
    test_step_input(false);
    test_step_input(true);
    test_sampled_input();
    test_switch();
    test_real_time();
    return report_done();
}
