/* A step of rk4 as one writes it who has a derivative and no generator: arrays, loops, a dense system that is solved in
 * each evaluation, the sines of libm. What tests/promises/cost/ratio.c measures the generated plants beside. */
#ifndef ISO_TESTS_COST_PLAIN_H
#define ISO_TESTS_COST_PLAIN_H

#include <math.h>
#include <stddef.h>

/* The states in the order of the generated plant, and its step. */
extern const size_t plain_states;
extern const double plain_start[];
void plain_step(double *x);

/* A plant says before it includes this how many STATES it has, and of how many UNKNOWNS its systems are. */
#ifdef STATES

/* a x = b by elimination, without pivoting: a is symmetric and positive definite. b becomes x. */
static inline void plain_solve(double a[UNKNOWNS][UNKNOWNS], double b[UNKNOWNS])
{
    for (size_t i = 0; i < UNKNOWNS; i++) {
        for (size_t r = i + 1; r < UNKNOWNS; r++) {
            const double factor = a[r][i] / a[i][i];
            for (size_t c = i; c < UNKNOWNS; c++) {
                a[r][c] -= factor * a[i][c];
            }
            b[r] -= factor * b[i];
        }
    }
    for (size_t i = UNKNOWNS; i-- > 0;) {
        for (size_t c = i + 1; c < UNKNOWNS; c++) {
            b[i] -= a[i][c] * b[c];
        }
        b[i] /= a[i][i];
    }
}

static void derivative(double *dx, const double *x);

/* A step of 1 ms. */
static inline void plain_rk4(double *const x)
{
    const size_t n = STATES;
    const double h = 0.001;
    double k[4][STATES], at[STATES];
    derivative(k[0], x);
    for (size_t stage = 1; stage < 4; stage++) {
        const double part = stage == 3 ? h : h / 2.0;
        for (size_t s = 0; s < n; s++) {
            at[s] = x[s] + part * k[stage - 1][s];
        }
        derivative(k[stage], at);
    }
    for (size_t s = 0; s < n; s++) {
        x[s] += h / 6.0 * (k[0][s] + 2.0 * k[1][s] + 2.0 * k[2][s] + k[3][s]);
    }
}

#endif

#endif
