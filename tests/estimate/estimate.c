/* What a checked method says of its local error, over what that error is, in every step of the first 5 s of the double
 * pendulum: 0.2 to 5.
 *
 * The true local error of a step is the distance of its increment from that of the solution through the state before it:
 * rk4 with SUBSTEPS steps in place of one, wrong by 64^-4 of an error of rk4. Of a state alone it passes through zero many
 * times a second; the largest of all states, which is what a method tells, does not. A multistep method makes the step
 * from its own history: for bdf4 that is the error constant over sigma(1), 1/5 h^5 x^(5) (Hairer, Norsett, Wanner 1993,
 * III.2). Sums are compensated, so that errors far below the ulp of the state are seen. The first quarter of a second is
 * left out: at rest with both arms horizontal odd derivatives vanish, and the leading term of the error with them.
 *
 * Estimates are right to the first order in h, and where the leading term is small the next ones decide: h must resolve
 * the motion, and does with 2^-10 s, a millisecond. In float an increment is wrong by some epsilons of itself, as its
 * slopes are: with steps that resolve the motion the errors of methods of order three and four are smaller than that now
 * and then, and nothing can tell them. Those of lower order are told, with the steps of the table.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/method.h"
#include "tests/host/report.h"
#include "tests/order/order.h"

enum {
    SECONDS = 5,
    PER_SECOND_MAX = 10,
    STEPS_MAX = SECONDS << PER_SECOND_MAX,
    SUBSTEPS = 64,
    N = 4,
    FACTORS_MAX = N * N,
    STATE_MAX = ISO_METHOD_STATE(ISO_AB4 | ISO_CHECKED | ISO_COMPENSATED, N),
};

/* What the ratio must be within. */
#define LEAST 0.2
#define MOST 5.0

typedef struct method {
    const char *name;
    unsigned recipe;
    int per_second; /* h = 2^-per_second s */
} method;

#ifdef ISO_REAL_DOUBLE
#define REAL_TEXT "double"
static const method methods[] = {
    {"euler", ISO_EULER, 10},
    {"semi_implicit", ISO_SEMI_IMPLICIT, 10},
    {"heun", ISO_HEUN, 10},
    {"rk4", ISO_RK4, 10},
    {"ab4", ISO_AB4, 10},
    {"abm4", ISO_ABM4, 10},
    {"abm4 pec", ISO_ABM4_PEC, 10},
    {"abm4 pecece", ISO_ABM4_PECECE, 10},
    {"rosenbrock", ISO_ROSENBROCK, 10},
    {"bdf4", ISO_BDF4, 10},
};
#else
#define REAL_TEXT "float"
static const method methods[] = {
    {"euler", ISO_EULER, 10},
    {"semi_implicit", ISO_SEMI_IMPLICIT, 10},
    {"heun", ISO_HEUN, 8},
};
#endif

/* A run: estimate and true error, step by step. */
static double estimate[STEPS_MAX + 1];
static double error[STEPS_MAX];
static double ratio[STEPS_MAX];

/* increment[N] of the solution through start over h. */
static void exact_increment(real increment[N], const real start[N], const real h)
{
    real x[2 * N] = {R(0.0)}, work[ISO_EXPLICIT_WORK(N)];
    const iso_trail trail = {.n = N, .x = x, .carry = x + N};
    memcpy(x, start, N * sizeof *x);
    for (int i = 0; i < SUBSTEPS; i++) {
        (void)iso_explicit_step(&iso_tableau_rk4, &trail, the_equations->derivative, h / (real)SUBSTEPS, NULL, NULL,
                                work);
    }
    for (int i = 0; i < N; i++) {
        increment[i] = (x[i] - start[i]) + x[N + i];
    }
}

/* A step from x, with the carry of its sums: how far its increment is from the solution's. */
typedef struct watch {
    real x[N], carry[N], exact[N];
} watch;

static void before_step(watch *const w, const real *const x, const real *const carry, const real h)
{
    memcpy(w->x, x, sizeof w->x);
    memcpy(w->carry, carry, sizeof w->carry);
    exact_increment(w->exact, x, h);
}

static double after_step(const watch *const w, const real *const x, const real *const carry)
{
    double largest = 0.0;
    for (int i = 0; i < N; i++) {
        const real made = (x[i] - w->x[i]) + (carry[i] - w->carry[i]);
        largest = fmax(largest, fabs((double)(made - w->exact[i])));
    }
    return largest;
}

static void start(real x[N])
{
    for (int i = 0; i < N; i++) {
        x[i] = (real)the_problem.start[i];
    }
}

static void run(const method *const m)
{
    const unsigned recipe = m->recipe | ISO_CHECKED | ISO_COMPENSATED;
    const real h = (real)ldexp(1.0, -m->per_second);
    real x[STATE_MAX] = {R(0.0)}, work[ISO_PRIME_WORK(N)], lu[FACTORS_MAX];
    const real *const carry = iso_trail_of(recipe, N, x).carry;
    iso_progress progress = {.local_error = R(0.0)};
    watch w;
    start(x);
    iso_method_prime(recipe, N, the_equations, h, x, NULL, NULL, lu, work);
    for (int step = 0; step < SECONDS << m->per_second; step++) {
        before_step(&w, x, carry, h);
        iso_method_step(recipe, N, the_equations, h, x, NULL, NULL, lu, work, &progress);
        error[step] = after_step(&w, x, carry);
        estimate[step] = (double)progress.local_error;
    }
}

static int compare(const void *const a, const void *const b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Fills ratio with those of all steps after a quarter of a second, sorted; returns how many. The estimate of a step
 * stands `behind` steps later. */
static int ratios(const int per_second, const int behind)
{
    int count = 0;
    for (int step = (1 << per_second) / 4; step + behind < SECONDS << per_second; step++) {
        ratio[count++] = estimate[step + behind] / error[step];
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
    run(m);
    const int count = ratios(m->per_second, ISO_CHECKS_SLOPES(m->recipe | ISO_CHECKED) ? 1 : 0);
    report_ok(within(count),
              "%s in " REAL_TEXT ", h = 2^-%d s: estimate / error in %d steps: %.3f to %.3f, median %.3f", m->name,
              m->per_second, count, ratio[0], ratio[count - 1], ratio[count / 2]);
}

/* Positive control: a method whose check has too few slopes. */
static void test_few_slopes(const iso_tableau *const table, const uint8_t checked, const char *const name)
{
    enum { PER_SECOND = 10 };
    const real h = (real)ldexp(1.0, -PER_SECOND);
    real x[N], carry[N] = {R(0.0)}, check[ISO_ADAMS_SLOPES * N] = {R(0.0)}, work[ISO_EXPLICIT_WORK(N)];
    const iso_trail trail = {.n = N, .x = x, .check = check, .carry = carry, .checked = checked};
    watch w;
    start(x);
    for (int step = 0; step < SECONDS << PER_SECOND; step++) {
        before_step(&w, x, carry, h);
        estimate[step] = (double)iso_explicit_step(table, &trail, the_equations->derivative, h, NULL, NULL, work);
        error[step] = after_step(&w, x, carry);
    }
    const int count = ratios(PER_SECOND, 1);
    report_ok(!within(count), "control: %s: %.3g to %.3g, median %.3g", name, ratio[0], ratio[count - 1],
              ratio[count / 2]);
}

int main(void)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        test_method(&methods[i]);
    }
    test_few_slopes(&iso_tableau_heun, 1, "heun checked with one slope before the end of the step");
    test_few_slopes(&iso_tableau_rk4, 4, "rk4 checked with four slopes");
    return report_done();
}
