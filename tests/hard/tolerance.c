#include "tests/hard/tolerance.h"

#include <math.h>

typedef struct adams_run {
    const hard_problem *problem;
    real h;
    real x[ISO_ADAMS_STATE(HARD_STATES_MAX)];
    real carry[HARD_STATES_MAX];
    real work[ISO_ADAMS_WORK(HARD_STATES_MAX)];
    iso_trail trail;
    iso_adams_options options;
    iso_adams_state state;
} adams_run;

static void begin(adams_run *const run, const hard_problem *const problem, const double tick, const double tolerance)
{
    memset(run, 0, sizeof *run);
    run->problem = problem;
    run->h = (real)tick;
    run->trail = (iso_trail){.n = problem->n, .x = run->x, .past = run->x + problem->n, .carry = run->carry};
    run->options = (iso_adams_options){
        .tolerance_absolute = (real)tolerance,
        .tolerance_relative = (real)tolerance,
        .budget = ISO_ADAMS_BUDGET_HOST,
        .level_max = ISO_ADAMS_LEVELS,
    };
    for (size_t s = 0; s < problem->n; s++) {
        run->x[s] = (real)problem->start[s];
    }
    iso_adams_start(&run->options, &run->state, &run->trail, problem->equations.derivative, run->h, NULL, problem->p,
                    run->work);
}

static void go(adams_run *const run, const long ticks)
{
    for (long i = 0; i < ticks; i++) {
        (void)iso_adams_tick(&run->options, &run->state, &run->trail, run->problem->equations.derivative, run->h, NULL,
                             run->problem->p, run->work);
    }
}

static void decay(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                  const real *restrict const p)
{
    (void)u;
    dx[0] = -p[0] * x[0];
}

/* The largest error of a state, in tolerances of 1 + |x|; infinite for a state that is not finite. */
static double error_of(const adams_run *const run, const long double *const exact, const double tolerance)
{
    double largest = 0.0;
    for (size_t s = 0; s < run->problem->n; s++) {
        const long double off = fabsl((long double)run->x[s] - exact[s]) / (1.0L + fabsl(exact[s]));
        largest = iso_not_finite(run->x[s]) == 0 ? fmax(largest, (double)off / tolerance) : HUGE_VAL;
    }
    return largest;
}

/* What the test equation tells. */
typedef struct swing {
    double largest;
    double square; /* the mean */
    double least;  /* sub-steps a decay */
    double most;
} swing;

static swing find_swing(const double tolerance)
{
    enum { LAMBDAS = 512, SETTLE = 20, TICKS = 380 };
    static adams_run run;
    const double tick = 0.01;
    swing found = {.least = HUGE_VAL};
    for (int i = 0; i < LAMBDAS; i++) {
        const real lambda = (real)(1000.0 * exp2((double)i / LAMBDAS));
        const hard_problem problem = {"decay", 1, {.derivative = decay}, {1.0}, &lambda};
        begin(&run, &problem, tick, tolerance);
        go(&run, SETTLE);
        const uint32_t before = run.state.substeps;
        for (int k = 0; k < TICKS; k++) {
            go(&run, 1);
            const double y = fabs((double)run.x[0]) / tolerance;
            found.largest = fmax(found.largest, y);
            found.square += y * y / TICKS / LAMBDAS;
        }
        const double rate = (run.state.substeps - before) / ((double)lambda * tick * TICKS);
        found.least = fmin(found.least, HARD_PICK(0.0, rate));
        found.most = fmax(found.most, rate);
    }
    return found;
}

void hard_expect_tolerance(const hard_problem *const problem, const hard_point *const points, const size_t count,
                           const hard_tolerance *const claim)
{
    static adams_run run;
    static adams_run loose;
    const double tolerance = claim->tolerance;
    const swing found = find_swing(tolerance);
    bool misses = false;
    double from = 0.0;
    begin(&run, problem, claim->tick, tolerance);
    begin(&loose, problem, claim->tick, 100.0 * tolerance);
    for (size_t i = 0; i < count; i++) {
        const long ticks = lround((points[i].t - from) / claim->tick);
        const double most = found.largest + claim->squared * found.square * tolerance * points[i].t +
                            claim->rounding * (double)ISO_REAL_EPSILON / tolerance;
        from = points[i].t;
        go(&run, ticks);
        go(&loose, ticks);
        const double error = error_of(&run, points[i].exact, tolerance);
        misses = misses || error_of(&loose, points[i].exact, tolerance) > most;
        report_ok(error <= most && run.state.budget_bound == 0,
                  "%s: adams at t = %g with a tolerance of %g: error %.3g tolerances, at most %.3g; %lu evaluations",
                  problem->name, points[i].t, tolerance, error, most, (unsigned long)run.state.evaluations);
    }
    const double rate = run.state.substeps / claim->decays;
    report_ok(rate >= found.least && rate <= found.most,
              "%s: adams takes %.3f sub-steps a decay, on the test equation %.3f to %.3f", problem->name, rate,
              found.least, found.most);
    report_ok(misses, "control: %s: with a hundred tolerances adams does not", problem->name);
}
