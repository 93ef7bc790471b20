/* Adams-Bashforth of order four: x += h / 24 (55 f - 59 f[-1] + 37 f[-2] - 9 f[-3]). */
#ifndef ISO_CORE_METHODS_AB4_H
#define ISO_CORE_METHODS_AB4_H

#include "core/methods/prime.h"

/* Bashforth and Adams (1883), An Attempt to Test the Theories of Capillary Action, ch. 3. */
static const iso_adams iso_table_ab4 = {.b = {55, -59, 37, -9}, .over = 24};

/* Derivatives in the formula, and sums kept: the part of the next step that the derivatives so far contribute. */
enum { ISO_AB4_STEPS = 4, ISO_AB4_SUMS = ISO_AB4_STEPS - 1 };

ISO_INLINE void iso_ab4_take_derivative(const iso_history *const history, const real h, const real *const derivative)
{
    iso_take_derivative(&iso_table_ab4, 1, ISO_AB4_SUMS, h, history->n, derivative, history->past);
}

/* Behind its first evaluation, the only one. Local error 251/720 h^5 x^(5). history->past[ISO_AB4_SUMS n]. */
ISO_INLINE void iso_ab4_step(iso_step *const step)
{
    const iso_history *const history = step->history;
    const real *const derivative = step->work;
    const real weight = iso_weight(&iso_table_ab4, step->h, 0);
    iso_step_begun(step);
    ISO_UNROLL
    for (size_t s = 0; s < history->n; s++) {
        iso_advance(history, s, weight * derivative[s] - history->past[s]);
    }
    iso_ab4_take_derivative(history, step->h, derivative);
}

static inline void iso_ab4_prime(iso_step *const step)
{
    const iso_history *const history = step->history;
    const uint8_t count = history->checked > 0 ? history->checked : ISO_AB4_STEPS;
    const real *const derivatives = iso_walk_back(step, count, false);
    for (uint8_t past = count; past-- > 0;) {
        iso_ab4_take_derivative(history, step->h, derivatives + past * history->n);
        iso_keep_derivative(history, step->h, derivatives + past * history->n);
    }
    iso_keep_moved(step);
}

/* The columns of core/methods/table.h. */
#define ISO_AB4_ORDER(r) 4
#define ISO_AB4_STAGES(r) 0
#define ISO_AB4_TABLEAU NULL
#define ISO_AB4_EVALUATIONS(r) 1
#define ISO_AB4_SOLUTIONS(r) 0
#define ISO_AB4_PAST(r) ISO_AB4_SUMS
#define ISO_AB4_WORK(r) 1
#define ISO_AB4_PRIME(r) ISO_PRIME_VECTORS
#define ISO_AB4_PRIMES(r) iso_ab4_prime
#define ISO_AB4_SUMS(r) 3
#define ISO_AB4_PRODUCTS(r) 4
#define ISO_AB4_KIND(r) ISO_FROM_START

#endif
