/* The fourth-order backward differentiation formula, for stiff plants.
 *
 * It solves with 1 - hb J, whose factors a plant computes from its analytic Jacobian J = df/dx, without a pivot search:
 * time and order of operations do not depend on data.
 */
#ifndef ISO_CORE_METHODS_BDF4_H
#define ISO_CORE_METHODS_BDF4_H

#include "core/methods/rosenbrock.h"

/* The fourth-order backward differentiation formula (Curtiss and Hirschfelder 1952; Gear 1971, Numerical Initial Value
 * Problems in Ordinary Differential Equations, table 11.1), 1/25 (48 y - 36 y[-1] + 16 y[-2] - 3 y[-3] + 12 h f),
 * in the increments of the steps before, which are small where the states are not:
 *     dx = 1/over (b[0] d + b[1] d[-1] + b[2] d[-2] + derivative h f). */
enum { ISO_BDF4_STEPS = 4 };

typedef struct iso_bdf {
    int8_t b[ISO_BDF4_STEPS - 1];
    int8_t derivative;
    int8_t over;
    int8_t predictor[ISO_BDF4_STEPS]; /* the increment that continues a polynomial of degree four */
} iso_bdf;

static const iso_bdf iso_table_bdf4 = {.b = {23, -13, 3}, .derivative = 12, .over = 25, .predictor = {4, -6, 4, -1}};

/* Stores an increment as the newest one. */
static inline void iso_keep_increment(const iso_history *const history, const size_t s, const real dx)
{
    ISO_UNROLL
    for (size_t j = ISO_BDF4_STEPS; j-- > 1;) {
        history->past[j * history->n + s] = history->past[(j - 1) * history->n + s];
    }
    history->past[s] = dx;
}

/* The sum of `terms` whole multiples of the kept increments of state s. */
static inline real iso_past_increments(const iso_history *const history, const size_t s, const int8_t *const c,
                                       const uint8_t terms)
{
    real sum = iso_whole(c[0]) * history->past[s];
    ISO_UNROLL
    for (uint8_t j = 1; j < terms; j++) {
        sum += iso_whole(c[j]) * history->past[j * history->n + s];
    }
    return sum;
}

/* The increment dx of iso_table_bdf4 by Newton iterations from the predictor, with the Jacobian there. The local error
 * is that of this step: the difference to the predictor is h^5 x^(5), since the kept increments are those of the
 * formula, and its error constant over sigma(1) is 1/5 (Hairer, Norsett, Wanner 1993, III.2). The residual is the
 * largest part of the last correction. history->past[ISO_BDF4_STEPS n], the newest first; work[4 n]. */
ISO_INLINE void iso_bdf4_step(iso_step *const step)
{
    const iso_bdf *const table = &iso_table_bdf4;
    const iso_history *const history = step->history;
    const iso_equations *const eq = step->equations;
    const size_t n = history->n;
    const real hb = step->h * (iso_whole(table->derivative) / iso_whole(table->over));
    real *const residual = &step->progress->residual;
    real *const at = step->work;
    real *const g = step->work + n;
    real *const past = step->work + 2 * n;
    real *const dx = step->work + 3 * n;
    real error = R(0.0);

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        dx[s] = iso_past_increments(history, s, table->predictor, ISO_BDF4_STEPS);
        at[s] = history->x[s] + dx[s];
        past[s] = R(1.0) / iso_whole(table->over) * iso_past_increments(history, s, table->b, ISO_BDF4_STEPS - 1);
    }
    const real *const u = iso_inputs_at(step, R(1.0));
    iso_linearise_at(step, g, at, u, hb);

    /* (1 - hb J) correction = past + hb f(x + dx) - dx; the increment is summed separately, since
     * corrections below half an ulp of x would be lost in x. */
    for (uint8_t i = 0; i < step->iterations; i++) {
        *residual = R(0.0);
        if (i > 0) {
            step->f(g, at, u, step->p);
        }
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            g[s] = (past[s] + hb * g[s]) - dx[s];
        }
        eq->solve(g, step->lu);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            dx[s] += g[s];
            at[s] = history->x[s] + dx[s];
            *residual = iso_larger(*residual, g[s]);
        }
    }

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real beyond = dx[s] - iso_past_increments(history, s, table->predictor, ISO_BDF4_STEPS);
        error = iso_larger(error, beyond);
        if (step->errors != NULL) {
            step->errors[s] = R(0.2) * beyond;
        }
        iso_keep_increment(history, s, dx[s]);
        iso_advance(history, s, dx[s]);
    }
    step->error = R(0.2) * error;
}

enum { ISO_BDF4_PRIME_VECTORS = 2 + ISO_ROSENBROCK_VECTORS };

/* Computes the increments before the first step. A stiff plant cannot be integrated backwards. So the linearly implicit
 * method computes five steps ahead, each in sub-steps, and the polynomial of degree four through their ends is
 * extrapolated to the past. The polynomial does not pass through the state itself: the state may be outside of the
 * smooth solution, in front of a layer that no step resolves. The formula then starts on the solution behind the layer,
 * and keeps its order. The local errors of order four and the extrapolation, exact to h^5, occur only here, so they
 * keep it too. x does not change. work[ISO_BDF4_PRIME_VECTORS n]. */
static inline void iso_bdf4_prime(iso_step *const step)
{
    enum { AHEAD = ISO_BDF4_STEPS + 1, SUBSTEPS = 2 };
    const iso_history *const history = step->history;
    const size_t n = history->n;
    real *const at = step->work;
    real *const compensation = step->work + n;
    const iso_history moving = {.n = n, .x = at, .compensation = compensation};
    iso_step ahead = *step;
    ahead.history = &moving;
    ahead.degree = 0;
    ahead.h = step->h / iso_whole(SUBSTEPS);
    ahead.work = compensation + n;
    memcpy(at, history->x, n * sizeof *at);
    for (size_t i = 0; i < AHEAD; i++) {
        real *const increment = history->past + (i > 0 ? i - 1 : 0) * n; /* the first one is overwritten */
        memcpy(increment, at, n * sizeof *at);
        memset(compensation, 0, n * sizeof *compensation);
        for (int j = 0; j < SUBSTEPS; j++) {
            iso_rosenbrock_step(&ahead);
        }
        for (size_t s = 0; s < n; s++) {
            increment[s] = (at[s] - increment[s]) + compensation[s];
        }
    }
    /* Seen backwards in time they are in the order of a history, the nearest first. So the predictor extrapolates
     * them to the past, and the result is reversed. */
    for (size_t s = 0; s < n; s++) {
        for (size_t i = 0; i < AHEAD; i++) {
            iso_keep_increment(history, s, iso_past_increments(history, s, iso_table_bdf4.predictor, ISO_BDF4_STEPS));
        }
        for (size_t j = 0; j < ISO_BDF4_STEPS / 2; j++) {
            real *const newer = history->past + j * n + s;
            real *const older = history->past + (ISO_BDF4_STEPS - 1 - j) * n + s;
            const real swap = *newer;
            *newer = *older;
            *older = swap;
        }
    }
}

/* The columns of core/methods/table.h. */
#define ISO_BDF4_ORDER(r) 4
#define ISO_BDF4_STAGES(r) 0
#define ISO_BDF4_TABLEAU NULL
#define ISO_BDF4_EVALUATIONS(r) ISO_ITERATIONS_OF(r)
#define ISO_BDF4_SOLUTIONS(r) ISO_ITERATIONS_OF(r)
#define ISO_BDF4_PAST(r) ISO_BDF4_STEPS
#define ISO_BDF4_WORK(r) 5
#define ISO_BDF4_PRIME(r) ISO_BDF4_PRIME_VECTORS
#define ISO_BDF4_PRIMES(r) iso_bdf4_prime
#define ISO_BDF4_SUMS(r) (7 + 5 * ISO_ITERATIONS_OF(r) + 5 * ISO_IS_CHECKED(r))
#define ISO_BDF4_PRODUCTS(r) (7 + ISO_ITERATIONS_OF(r) + 3 * ISO_IS_CHECKED(r))
#define ISO_BDF4_KIND(r) ISO_ITERATING

#endif
