#include "tests/promises/hard/hard.h"

#include <complex.h>
#include <math.h>

#include "core/runtime/hash.h"
#include "tests/general.h"

/* The accepted distance of an observed order from the method's, where the stiff part of the error has not died away. */
#define ORDER_TOLERANCE 0.35

const char *hard_name(const unsigned recipe)
{
    static const char *const names[ISO_METHODS] = ISO_METHOD_NAMES;
    return names[ISO_METHOD_OF(recipe)];
}

void hard_prime(hard_run *const run)
{
    general_prime(run->recipe, run->problem->n, &run->problem->equations, run->h, run->x, run->u, run->problem->p,
                  run->lu, run->work, &run->progress.progress);
}

void hard_begin(hard_run *const run, const hard_problem *const problem, const unsigned recipe, const double h)
{
    memset(run, 0, sizeof *run);
    run->problem = problem;
    run->recipe = recipe;
    run->h = (real)h;
    for (size_t i = 0; i < problem->n; i++) {
        run->x[i] = (real)problem->start[i];
    }
    hard_prime(run);
}

size_t hard_guard(const hard_run *const run)
{
    size_t i = 0;
    while (i < run->problem->n && iso_not_finite(run->x[i]) == 0) {
        i++;
    }
    return i;
}

long hard_go(hard_run *const run, const long steps)
{
    long taken = 0;
    while (taken < steps && hard_guard(run) == run->problem->n) {
        general_step(run->recipe, run->problem->n, &run->problem->equations, run->h, run->x, run->u, run->problem->p,
                     run->lu, run->work, &run->progress.progress);
        taken++;
    }
    return taken;
}

hard_bits hard_hash(const real *const x, const size_t n)
{
    uint64_t hash = iso_hash_reals(ISO_HASH_START, x, n);
    for (size_t i = 0; i < n; i++) {
        hash = iso_not_finite(x[i]) == 0 ? hash : 0;
    }
    return (hard_bits){(unsigned long)(hash >> 32), (unsigned long)(hash & 0xFFFFFFFF)};
}

double hard_error(const hard_run *const run, const long double *const exact)
{
    long double largest = hard_guard(run) < run->problem->n ? (long double)INFINITY : 0.0L;
    for (size_t i = 0; i < run->problem->n; i++) {
        largest = fmaxl(largest, fabsl(((long double)run->x[i] - exact[i]) / exact[i]));
    }
    return (double)largest;
}

void hard_expect_failure(const hard_problem *const problem, const unsigned recipe, const double h, const long steps)
{
    enum { AFTER = 100 };
    static hard_run run;
    hard_begin(&run, problem, recipe, h);
    const long taken = hard_go(&run, steps);
    const size_t state = hard_guard(&run);
    bool stays = state < problem->n;
    for (int i = 0; i < AFTER && stays; i++) {
        general_step(recipe, problem->n, &problem->equations, run.h, run.x, run.u, problem->p, run.lu, run.work,
                     &run.progress.progress);
        stays = hard_guard(&run) < problem->n;
    }
    report_ok(stays, "control: %s, %s, h = %g s: state %d is not finite after %ld steps, and stays so", problem->name,
              hard_name(recipe), h, (int)state, taken);
}

void hard_expect_explicit_failures(const hard_problem *const problem, const double h, const long steps)
{
    static const unsigned recipes[] = {ISO_EULER, ISO_HEUN, ISO_RK4, ISO_AB4, ISO_ABM4, ISO_ABM4_PEC, ISO_ABM4_PECECE};
    for (size_t i = 0; i < sizeof recipes / sizeof *recipes; i++) {
        hard_expect_failure(problem, recipes[i], h, steps);
    }
}

/* The largest difference of a state between two runs, relative to the solution. */
static double difference(const hard_run *const a, const hard_run *const b, const long double *const exact)
{
    long double largest = 0.0L;
    for (size_t s = 0; s < a->problem->n; s++) {
        largest = fmaxl(largest, fabsl(((long double)a->x[s] - (long double)b->x[s]) / exact[s]));
    }
    return (double)largest;
}

/* Whether three runs at steps halved twice tell the method's order and, by themselves, their error. */
static bool tell_order(const hard_run run[3], const hard_claim *const claim, const double error)
{
    const double coarse = difference(&run[0], &run[1], claim->exact);
    const double fine = difference(&run[1], &run[2], claim->exact);
    const double allowed = coarse * coarse / (coarse - fine);
    const double order = log2(coarse / fine);
    report_note("order %.2f; error %.2e, as told by the differences between the runs %.2e", order, error, allowed);
    return fabs(order - claim->order) <= ORDER_TOLERANCE && allowed <= 1.5 * error && error <= 1.5 * allowed;
}

bool hard_holds(const hard_problem *const problem, const hard_claim *const claim, const double rounding)
{
    static hard_run run[3];
    bool all = true;
    for (unsigned compensated = 0; compensated <= 1; compensated++) {
        const unsigned recipe = claim->recipe | (compensated ? ISO_COMPENSATED : 0U);
        double error[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < (claim->order > 0 ? 3 : 1); i++) {
            const long n = claim->n << i;
            hard_begin(&run[i], problem, recipe, claim->t / (double)n);
            (void)hard_go(&run[i], n);
            error[i] = hard_error(&run[i], claim->exact);
            const double steps = compensated ? 0.0 : 0.5 * (double)n;
            const double most = claim->error * exp2(-(claim->order - ORDER_TOLERANCE) * i) +
                                (double)ISO_REAL_EPSILON * (rounding + steps);
            const hard_bits hash = hard_hash(run[i].x, problem->n);
            report_note("%s%s, t = %g, h = %g: error %.2e, at most %.2e; hash %08lx%08lx", hard_name(recipe),
                        compensated ? ", compensated" : "", claim->t, claim->t / (double)n, error[i], most, hash.high,
                        hash.low);
            all = all && error[i] <= most;
        }
        if (sizeof(real) == sizeof(double) && claim->order > 0 && compensated) {
            all = tell_order(run, claim, error[0]) && all;
        }
    }
    return all;
}

static void factor_nothing(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                           const real *restrict const p, const real hb)
{
    (void)lu;
    (void)x;
    (void)u;
    (void)p;
    (void)hb;
}

static void solve_nothing(real *restrict const d, const real *restrict const lu)
{
    (void)d;
    (void)lu;
}

bool hard_affords(const hard_problem *const problem, const unsigned recipe, const double t, const long steps)
{
    if (steps > HARD_STEPS_MAX) {
        report_note("%s: %s at t = %g with %ld steps is left out", problem->name, hard_name(recipe), t, steps);
    }
    return steps <= HARD_STEPS_MAX;
}

void hard_expect_claims(const hard_problem *const problem, const hard_claim *const claims, const size_t count,
                        const double rounding)
{
    for (size_t i = 0; i < count; i++) {
        const hard_claim *const c = &claims[i];
        if (!hard_affords(problem, c->recipe, c->t, c->n)) {
            continue;
        }
        const bool holds = hard_holds(problem, c, rounding);
        report_ok(holds, "%s: %s at t = %g with h = %g s: error at most %.1e and rounding%s", problem->name,
                  hard_name(c->recipe), c->t, c->t / (double)c->n, c->error,
                  c->order > 0 ? ", less as h is halved" : "");
    }
    if (claims[count - 1].n > HARD_STEPS_MAX) {
        return;
    }
    hard_problem blind = *problem;
    blind.equations.factor = factor_nothing;
    blind.equations.solve = solve_nothing;
    const bool holds = hard_holds(&blind, &claims[count - 1], rounding);
    report_ok(!holds, "control: %s: without a Jacobian %s does not", problem->name,
              hard_name(claims[count - 1].recipe));
}

double hard_bdf4_growth(const double re, const double im)
{
    enum { ROOTS = 4, SWEEPS = 200 };
    const double complex z = re + im * (double complex)I;
    const double complex lead = 25.0 - 12.0 * z;
    double complex root[ROOTS];
    for (int i = 0; i < ROOTS; i++) {
        root[i] = cpow(0.4 + 0.9 * (double complex)I, i);
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (int i = 0; i < ROOTS; i++) {
            const double complex r = root[i];
            double complex others = lead;
            for (int j = 0; j < ROOTS; j++) {
                others *= j == i ? 1.0 : r - root[j];
            }
            root[i] -= ((((lead * r - 48.0) * r + 36.0) * r - 16.0) * r + 3.0) / others;
        }
    }
    double largest = 0.0;
    for (int i = 0; i < ROOTS; i++) {
        largest = fmax(largest, cabs(root[i]));
    }
    return largest;
}
