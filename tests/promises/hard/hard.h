/* The hard cases: equations written by hand with their analytic Jacobian, run by any method through iso_method_step. A
 * case is one program, compiled in float and in double. Every run starts primed, as a plant does. */
#ifndef ISO_TESTS_HARD_HARD_H
#define ISO_TESTS_HARD_HARD_H

#include <limits.h>
#include <stdbool.h>

#include "core/methods/all.h"
#include "core/methods/dense.h"
#include "core/methods/method.h"
#include "tests/host/report.h"

#ifdef ISO_REAL_DOUBLE
#define HARD_REAL "double"
#else
#define HARD_REAL "float"
#endif

/* What holds in this program's real. */
#define HARD_PICK(in_float, in_double) (sizeof(real) == sizeof(double) ? (in_double) : (in_float))

/* The most steps that a test may take; fewer where instructions are emulated. */
#ifndef HARD_STEPS_MAX
#define HARD_STEPS_MAX LONG_MAX
#endif

enum { HARD_STATES_MAX = 20 };

typedef struct hard_problem {
    const char *name;
    size_t n;
    iso_equations equations;
    double start[HARD_STATES_MAX];
    const real *p;
} hard_problem;

/* A method on a problem. u are the inputs, if it has some. */
typedef struct hard_run {
    const hard_problem *problem;
    unsigned recipe;
    real h;
    real u[1];
    real x[ISO_METHOD_STATE(ISO_AB4 | ISO_CHECKED | ISO_COMPENSATED, HARD_STATES_MAX)];
    real lu[HARD_STATES_MAX * HARD_STATES_MAX];
    real work[ISO_PRIME_VECTORS * HARD_STATES_MAX];
    iso_any_progress progress;
} hard_run;

const char *hard_name(unsigned recipe);

/* At the problem's start, primed, the input zero. */
void hard_begin(hard_run *run, const hard_problem *problem, unsigned recipe, double h);

/* Primes again: what the method keeps is made anew from the state and the input. */
void hard_prime(hard_run *run);

/* Takes so many steps, or fewer: it stops after the one that leaves a state not finite. Returns the steps taken. */
long hard_go(hard_run *run, long steps);

/* The first state that is not finite; n if all are. */
size_t hard_guard(const hard_run *run);

/* A hash of the bits of x[n], as two numbers that every printf knows; zero where they are not all finite, since the
 * bits of a NaN are not promised. */
typedef struct hard_bits {
    unsigned long high, low;
} hard_bits;
hard_bits hard_hash(const real *x, size_t n);

/* The largest error of a state, relative to the solution's: max |x - exact| / |exact|; infinite for a state that is not
 * finite. */
double hard_error(const hard_run *run, const long double *exact);

/* One test: explicit methods that cannot take this step say so. Within `steps` the state is not finite, and stays so:
 * no later state looks right again. */
void hard_expect_failure(const hard_problem *problem, unsigned recipe, double h, long steps);

/* The same of every explicit method of general equations. */
void hard_expect_explicit_failures(const hard_problem *problem, double h, long steps);

/* What a method must reach on a stiff problem: at time t after n steps the error is at most `error`, and 2^order less
 * with every halving of the step; order 0 is a single run. */
typedef struct hard_claim {
    unsigned recipe;
    double t;
    const long double *exact;
    long n;
    double error;
    int order;
} hard_claim;

/* Whether the claim holds, with and without compensation, in this program's real. To the error of the method comes that
 * of rounding, `rounding` epsilons that the equations make by themselves, and half an epsilon a step where sums are not
 * compensated. In double the order must also show between the runs, and the error be what the differences between them
 * allow: a step's digits are known without the solution. Prints what it found. */
bool hard_holds(const hard_problem *problem, const hard_claim *claim, double rounding);

/* Whether a test may take so many steps; says which one is left out. */
bool hard_affords(const hard_problem *problem, unsigned recipe, double t, long steps);

/* One test of every claim that can be afforded, and the control that without a Jacobian the last of them does not hold.
 */
void hard_expect_claims(const hard_problem *problem, const hard_claim *claims, size_t count, double rounding);

/* The growth per step of y' = z y / h by bdf4: the largest root of (25 - 12 z) r^4 - 48 r^3 + 36 r^2 - 16 r + 3, all
 * found at once (Durand 1960; Kerner 1966). */
double hard_bdf4_growth(double re, double im);

#endif
