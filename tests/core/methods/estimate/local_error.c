#include "tests/core/methods/estimate/local_error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/core/methods/order/order.h"
#include "tests/one_step.h"

/* Steps of the reference in place of one. */
enum { SUBSTEPS = 64 };

/* What a ratio must be within, and of how many steps. */
#define LEAST 0.2
#define MOST 5.0
enum { ENOUGH = 100 };

/* Epsilons of an increment that its roundings can make: it is a sum of derivatives whose weights add up to at most 6.7
 * in size (Adams-Bashforth), each wrong by half an epsilon as a derivative and by half one as a product, and the sum
 * itself. */
#define ROUNDINGS 8.0

/* increment[STATES] of the solution through start over h. */
static void exact_increment(real increment[STATES], const real start[STATES], const real h)
{
    real x[2 * STATES] = {R(0.0)}, work[ISO_EXPLICIT_VECTORS * STATES];
    const iso_history history = {.n = STATES, .x = x, .compensation = x + STATES};
    memcpy(x, start, STATES * sizeof *x);
    for (int i = 0; i < SUBSTEPS; i++) {
        (void)one_explicit_step(&iso_tableau_rk4, &history, the_equations->derivative, h / (real)SUBSTEPS, NULL, NULL,
                                work);
    }
    for (int i = 0; i < STATES; i++) {
        increment[i] = (x[i] - start[i]) + x[STATES + i];
    }
}

void solution(real x[STATES], const real h, const int steps)
{
    for (int step = 0; step < steps; step++) {
        real increment[STATES];
        exact_increment(increment, x, h);
        for (int i = 0; i < STATES; i++) {
            x[i] += increment[i];
        }
    }
}

void before_step(watch *const w, const real *const x, const real *const compensation, const real h)
{
    memcpy(w->x, x, sizeof w->x);
    memcpy(w->compensation, compensation, sizeof w->compensation);
    exact_increment(w->exact, x, h);
}

local_error after_step(const watch *const w, const real *const x, const real *const compensation,
                       const double weight[STATES])
{
    local_error of = {0.0, 0.0};
    for (int i = 0; i < STATES; i++) {
        const real made = (x[i] - w->x[i]) + (compensation[i] - w->compensation[i]);
        of.error = fmax(of.error, weight[i] * fabs((double)(made - w->exact[i])));
        of.rounding = fmax(of.rounding, weight[i] * ROUNDINGS * (double)ISO_REAL_EPSILON * fabs((double)w->exact[i]));
    }
    return of;
}

void ratios_add(ratios *const r, const double estimate, const local_error of)
{
    if (of.error > of.rounding && r->count < RATIOS_MAX) {
        r->list[r->count++] = estimate / of.error;
    } else {
        r->unseen++;
    }
}

static int compare(const void *const a, const void *const b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

void ratios_sort(ratios *const r)
{
    qsort(r->list, (size_t)r->count, sizeof *r->list, compare);
}

static double ratio_at(const ratios *const r, const int i)
{
    return r->count > 0 ? r->list[i] : 0.0;
}

double ratios_least(const ratios *const r)
{
    return ratio_at(r, 0);
}

double ratios_median(const ratios *const r)
{
    return ratio_at(r, r->count / 2);
}

double ratios_most(const ratios *const r)
{
    return ratio_at(r, r->count - 1);
}

bool ratios_within(const ratios *const r)
{
    return r->count >= ENOUGH && ratios_least(r) >= LEAST && ratios_most(r) <= MOST;
}
