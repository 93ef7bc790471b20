/* What a checked method says of its local error, over what that error is, along the first 5 s of the double pendulum.
 *
 * The true local error of a step is the distance, largest of the states, of its increment from that of the solution
 * through the state before it: rk4 with SUBSTEPS steps in place of one, wrong by 64^-4 of an error of rk4. A multistep
 * method makes the step from its own history. For bdf4 that history lies off this solution by errors of its own order, so
 * that the distance tends to 1/5 h^5 x^(5) (Hairer, Norsett, Wanner 1993, III.2: the error constant over sigma(1)) where
 * 12/137 is estimated: its ratio tends to 60/137 = 0.438, that of the others to 1. Sums are compensated, so that errors
 * far below the ulp of the state are seen.
 *
 * Estimates are right to the first order in h, and where the leading term of the error passes through zero the next one
 * decides: h must be so short that the ratio holds in every step. The errors of rk4 in all states are nearly multiples of
 * one number, which passes through zero many times a second: for rk4 the largest estimate of a sixteenth of a second is
 * held against the largest error there, as who looks at the largest does. The first quarter of a second is left out: at
 * rest with both arms horizontal odd derivatives vanish, and the leading term with them. In double.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/method.h"
#include "tests/host/report.h"
#include "tests/order/order.h"

enum {
    SECONDS = 5,
    PER_SECOND_MAX = 11,
    STEPS_MAX = SECONDS << PER_SECOND_MAX,
    SUBSTEPS = 64,
    N = 4,
    FACTORS_MAX = N * N,
    STATE_MAX = 8 * N,
    KEPT_MAX = 4,
};

/* What the ratio must be within. */
#define LEAST 0.2
#define MOST 5.0

typedef struct method {
    const char *name;
    unsigned recipe;
    int per_second; /* h = 2^-per_second s */
    int window;     /* log2 of the steps whose largest estimate and error are compared */
} method;

static const method methods[] = {
    {"euler", ISO_EULER, 9, 0},
    {"semi_implicit", ISO_SEMI_IMPLICIT, 9, 0},
    {"heun", ISO_HEUN, 10, 0},
    {"rk4", ISO_RK4, 11, 7},
    {"ab4", ISO_AB4, 9, 0},
    {"abm4", ISO_ABM4, 10, 0},
    {"abm4 pec", ISO_ABM4_PEC, 10, 0},
    {"abm4 pecece", ISO_ABM4_PECECE, 10, 0},
    {"rosenbrock", ISO_ROSENBROCK, 11, 0},
    {"bdf4", ISO_BDF4, 10, 0},
};

/* A run: estimate and true error, step by step. */
static double estimate[STEPS_MAX + 1];
static double error[STEPS_MAX];
static double ratio[STEPS_MAX];

/* increment[N] of the solution through start over h. */
static void exact_increment(double increment[N], const double start[N], const double h)
{
    double x[2 * N] = {0.0}, work[ISO_EXPLICIT_WORK(N)];
    const iso_trail trail = {.n = N, .x = x, .carry = x + N};
    memcpy(x, start, N * sizeof *x);
    for (int i = 0; i < SUBSTEPS; i++) {
        (void)iso_explicit_step(&iso_tableau_rk4, &trail, the_equations->derivative, h / SUBSTEPS, NULL, NULL, work);
    }
    for (int i = 0; i < N; i++) {
        increment[i] = (x[i] - start[i]) + x[N + i];
    }
}

/* A step from x, with the carry of its sums: how far its increment is from the solution's. */
typedef struct watch {
    double x[N], carry[N], exact[N];
} watch;

static void before_step(watch *const w, const double *const x, const double *const carry, const double h)
{
    memcpy(w->x, x, sizeof w->x);
    memcpy(w->carry, carry, sizeof w->carry);
    exact_increment(w->exact, x, h);
}

static double after_step(const watch *const w, const double *const x, const double *const carry)
{
    double largest = 0.0;
    for (int i = 0; i < N; i++) {
        const double made = (x[i] - w->x[i]) + (carry[i] - w->carry[i]);
        largest = fmax(largest, fabs(made - w->exact[i]));
    }
    return largest;
}

static void run(const method *const m)
{
    const unsigned recipe = m->recipe | ISO_CHECKED | ISO_COMPENSATED;
    const double h = ldexp(1.0, -m->per_second);
    double x[STATE_MAX] = {0.0}, work[ISO_EXPLICIT_WORK(N) + N], lu[FACTORS_MAX];
    const double *const carry = iso_trail_of(recipe, N, x).carry;
    iso_progress progress = {.started = 0};
    watch w;
    memcpy(x, the_problem.start, N * sizeof *x);
    iso_method_prime(recipe, N, the_equations, h, x, NULL, NULL, work, &progress);
    for (int step = 0; step < SECONDS << m->per_second; step++) {
        before_step(&w, x, carry, h);
        iso_method_step(recipe, N, the_equations, h, x, NULL, NULL, lu, work, &progress);
        error[step] = after_step(&w, x, carry);
        estimate[step] = progress.local_error;
    }
}

static int compare(const void *const a, const void *const b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

static double largest_of(const double *const values, const int count)
{
    double largest = 0.0;
    for (int i = 0; i < count; i++) {
        largest = fmax(largest, values[i]);
    }
    return largest;
}

/* Fills ratio with those of all windows after a quarter of a second, sorted; returns how many. The estimate of a step
 * stands `behind` steps later. */
static int ratios(const int per_second, const int window, const int behind)
{
    const int size = 1 << window;
    int count = 0;
    for (int step = (1 << per_second) / 4; step + size + behind <= SECONDS << per_second; step += size) {
        ratio[count++] = largest_of(estimate + step + behind, size) / largest_of(error + step, size);
    }
    qsort(ratio, (size_t)count, sizeof *ratio, compare);
    return count;
}

static bool within(const int count)
{
    return count > 0 && ratio[0] >= LEAST && ratio[count - 1] <= MOST;
}

static void test_method(const method *const m)
{
    const int behind = ISO_CHECKS_SLOPES(m->recipe | ISO_CHECKED) ? 1 : 0;
    run(m);
    const int count = ratios(m->per_second, m->window, behind);
    report_ok(within(count), "%s, h = 2^-%d s: estimate / error over %d x %d steps: %.3f to %.3f, median %.3f", m->name,
              m->per_second, count, 1 << m->window, ratio[0], ratio[count - 1], ratio[count / 2]);
}

/* Positive control: a method checked as if it were of another order. */
static void test_wrong_order(const iso_tableau *const table, const uint8_t order, const int window,
                             const char *const name)
{
    enum { PER_SECOND = 11 };
    const double h = ldexp(1.0, -PER_SECOND);
    double x[N], carry[N] = {0.0}, moved[N], slopes[KEPT_MAX * N], work[ISO_EXPLICIT_WORK(N)], at[N];
    const iso_trail trail = {
        .n = N, .x = x, .slopes = slopes, .moved = moved, .carry = carry, .kept = order, .order = order};
    watch w;
    memcpy(x, the_problem.start, sizeof x);
    iso_prime_slopes(&trail, the_equations->derivative, h, NULL, NULL, false, at, work);
    for (int step = 0; step < SECONDS << PER_SECOND; step++) {
        before_step(&w, x, carry, h);
        estimate[step] = iso_explicit_step(table, &trail, the_equations->derivative, h, NULL, NULL, work);
        error[step] = after_step(&w, x, carry);
    }
    const int count = ratios(PER_SECOND, window, 1);
    report_ok(!within(count), "control: %s: %.3g to %.3g, median %.3g", name, ratio[0], ratio[count - 1],
              ratio[count / 2]);
}

int main(void)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        test_method(&methods[i]);
    }
    test_wrong_order(&iso_tableau_heun, 1, 0, "heun checked as of order 1");
    test_wrong_order(&iso_tableau_rk4, 3, 7, "rk4 checked as of order 3");
    return report_done();
}
