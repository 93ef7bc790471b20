#include "tests/promises/hard/tolerance.h"

#include <math.h>

#include "tests/core/methods/adaptive/run.h"

typedef struct tolerance_run {
    const hard_problem *problem;
    real h;
    real compensation[ADAMS_STATES_MAX];
    adams_memory memory;
} tolerance_run;

/* Compensated, with as many sub-steps as it takes. */
static void begin(tolerance_run *const run, const hard_problem *const problem, const double tick,
                  const double tolerance)
{
    real start[ADAMS_STATES_MAX] = {R(0.0)};
    adams_memory *const m = &run->memory;
    memset(run, 0, sizeof *run);
    run->problem = problem;
    run->h = (real)tick;
    for (size_t s = 0; s < problem->n; s++) {
        start[s] = (real)problem->start[s];
    }
    adams_prepare(m, problem->n, start, (real)tolerance, ISO_ADAMS_BUDGET_HOST);
    m->history.compensation = run->compensation;
    iso_step step = adams_step_of(m, problem->equations.derivative, run->h, NULL, problem->p);
    iso_adams_prime(&step);
}

static void go(tolerance_run *const run, const long ticks)
{
    adams_memory *const m = &run->memory;
    for (long i = 0; i < ticks; i++) {
        iso_step step = adams_step_of(m, run->problem->equations.derivative, run->h, NULL, run->problem->p);
        iso_adams_step(&step);
    }
}

static void decay(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                  const real *restrict const p)
{
    (void)u;
    dx[0] = -p[0] * x[0];
}

/* The largest error of a state, in tolerances of 1 + |x|; infinite for a state that is not finite. */
static double error_of(const tolerance_run *const run, const long double *const exact, const double tolerance)
{
    double largest = 0.0;
    for (size_t s = 0; s < run->problem->n; s++) {
        const long double off = fabsl((long double)run->memory.x[s] - exact[s]) / (1.0L + fabsl(exact[s]));
        largest = iso_not_finite(run->memory.x[s]) == 0 ? fmax(largest, (double)off / tolerance) : HUGE_VAL;
    }
    return largest;
}

/* What the test equation tells. */
typedef struct swing {
    double largest;
    double square; /* the largest mean of a lambda */
    double least;  /* sub-steps a decay */
    double most;
} swing;

static swing find_swing(const double tolerance)
{
    enum { LAMBDAS = 512, SETTLE = 20, TICKS = 380 };
    static tolerance_run run;
    const double tick = 0.01;
    swing found = {.least = HUGE_VAL};
    for (int i = 0; i < LAMBDAS; i++) {
        const real lambda = (real)(1000.0 * exp2((double)i / LAMBDAS));
        const hard_problem problem = {"decay", 1, {.derivative = decay}, {1.0}, &lambda};
        begin(&run, &problem, tick, tolerance);
        go(&run, SETTLE);
        const uint32_t before = run.memory.state.substeps;
        double square = 0.0;
        for (int k = 0; k < TICKS; k++) {
            go(&run, 1);
            const double y = fabs((double)run.memory.x[0]) / tolerance;
            found.largest = fmax(found.largest, y);
            square += y * y / TICKS;
        }
        found.square = fmax(found.square, square);
        const double rate = (run.memory.state.substeps - before) / ((double)lambda * tick * TICKS);
        found.least = fmin(found.least, rate);
        found.most = fmax(found.most, rate);
    }
    return found;
}

void hard_expect_tolerance(const hard_problem *const problem, const hard_point *const points, const size_t count,
                           const hard_tolerance *const claim)
{
    static tolerance_run run;
    static tolerance_run loose;
    const double tolerance = claim->tolerance;
    if (!hard_affords(problem, ISO_ADAMS, points[count - 1].t, (long)claim->decays)) {
        return;
    }
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
        const double error = error_of(&run, points[i].exact, tolerance);
        if (!misses) {
            go(&loose, ticks);
            misses = error_of(&loose, points[i].exact, tolerance) > most;
        }
        report_ok(error <= most && run.memory.state.budget_bound == 0,
                  "%s: adams at t = %g with a tolerance of %g: error %.3g tolerances, at most %.3g; %lu evaluations",
                  problem->name, points[i].t, tolerance, error, most, (unsigned long)run.memory.state.evaluations);
        const hard_bits hash = hard_hash(run.memory.x, problem->n);
        report_note("hash %08lx%08lx", hash.high, hash.low);
    }
    if (sizeof(real) == sizeof(double)) {
        const double rate = run.memory.state.substeps / claim->decays;
        report_ok(rate >= found.least && rate <= found.most,
                  "%s: adams takes %.3f sub-steps a decay, on the test equation %.3f to %.3f", problem->name, rate,
                  found.least, found.most);
    }
    report_ok(misses, "control: %s: with a hundred tolerances adams does not", problem->name);
}
