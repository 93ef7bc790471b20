/* The true local error of a step of the double pendulum, and how many times that is what a method tells of it. */
#ifndef ISO_TESTS_ESTIMATE_LOCAL_ERROR_H
#define ISO_TESTS_ESTIMATE_LOCAL_ERROR_H

#include <stdbool.h>

#include "core/methods/all.h"
#include "core/methods/method.h"

enum { STATES = 4, RATIOS_MAX = 1 << 16 };

/* x after so many steps of h, as exact as the reference of a step is. */
void solution(real x[STATES], real h, int steps);

/* A step from x, with the compensation of its sums. */
typedef struct watch {
    real x[STATES], compensation[STATES], exact[STATES];
} watch;

void before_step(watch *w, const real *x, const real *compensation, real h);

/* How far the step's increment is from the solution's, and how far it can be from rounding alone: the largest of all
 * states, each times its weight. */
typedef struct local_error {
    double error, rounding;
} local_error;

local_error after_step(const watch *w, const real *x, const real *compensation, const double weight[STATES]);

/* Estimate over error of the steps whose error is more than rounding. */
typedef struct ratios {
    int count;
    int unseen; /* steps that are not in the list */
    double list[RATIOS_MAX];
} ratios;

void ratios_add(ratios *r, double estimate, local_error of);

/* Of those after ratios_sort; zero if there are none. */
void ratios_sort(ratios *r);
double ratios_least(const ratios *r);
double ratios_median(const ratios *r);
double ratios_most(const ratios *r);

/* Whether there are enough, and all are within 0.2 to 5. */
bool ratios_within(const ratios *r);

#endif
