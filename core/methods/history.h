/* The history: the values that a method keeps from step to step, behind the states. The functions here serve every
 * method: they advance the state, keep derivatives, and check a step.
 *
 * Pointers and counts are known at compile time: a pointer that is NULL, or a count that is zero, leaves no code.
 */
#ifndef ISO_CORE_METHODS_HISTORY_H
#define ISO_CORE_METHODS_HISTORY_H

#include <stdbool.h>

#include "core/methods/equations.h"
#include "core/methods/implicit_adams.h"
#include "core/numbers/exact.h"
#include "core/numbers/unroll.h"

typedef struct iso_history {
    size_t n;
    real *x;            /* [n] the states */
    real *past;         /* of the method: sums of derivatives, increments, or rows of a polynomial */
    real *check;        /* [checked n] sums of the derivatives so far, the increment less the first one: iso_check */
    real *compensation; /* [n] the rounding errors of x so far; NULL if x is not compensated */
    uint8_t checked;    /* derivatives before the end of a step that its check uses; 0 if steps are not checked */
    bool centred;       /* whether that check is centred: iso_check_centred */
} iso_history;

/* The check of a method of order four that makes a step from its start alone is the difference between the increments d
 * of three steps and the formula of order six in their derivatives, here over 60:
 *
 *     11 d + 38 d[-1] + 11 d[-2] = 3 h (f + 9 f[-1] + 9 f[-2] + f[-3])
 *
 * (Lambert 1973, Computational Methods in Ordinary Differential Equations, 2.10). It is the mean of the errors of these
 * steps, which is that of the middle one to the second order in h. It is off by h^7 x^(7) / 2800. An Adams formula of
 * its order is off by 40 times that: with steps as long as rk4 allows, by more than rk4 itself. */
enum { ISO_CENTRED_KEPT = 3, ISO_CENTRED_OUTER = 11, ISO_CENTRED_MIDDLE = 38, ISO_CENTRED_OVER = 60 };

/* Adds a part of the last increment of a state to the sums of its centred check: to those of this step and the next
 * two.
 */
static inline void iso_check_centred(const iso_history *const history, const size_t s, const real dx)
{
    const size_t n = history->n;
    const real outer = iso_whole(ISO_CENTRED_OUTER) / iso_whole(ISO_CENTRED_OVER) * dx;
    history->check[s] += outer;
    history->check[n + s] += iso_whole(ISO_CENTRED_MIDDLE) / iso_whole(ISO_CENTRED_OVER) * dx;
    history->check[2 * n + s] += outer;
}

/* x[s] += dx. Compensated: the rounding error of the sum is added with the next change (Kahan 1965; Moller 1965). */
static inline void iso_add(const iso_history *const history, const size_t s, const real dx)
{
    if (history->compensation == NULL) {
        history->x[s] += dx;
    } else {
        const real x = history->x[s];
        const real add = dx + history->compensation[s];
        const real sum = x + add;
        history->compensation[s] = iso_rest_of_sum(x, add, sum);
        history->x[s] = sum;
    }
}

/* x[s] += dx, the increment of a step. */
static inline void iso_advance(const iso_history *const history, const size_t s, const real dx)
{
    if (history->centred) {
        iso_check_centred(history, s, dx);
    } else if (history->checked > 0) {
        history->check[s] = dx - history->check[s];
    }
    iso_add(history, s, dx);
}

/* h b[j] / over if j is before `end`, else zero. */
ISO_INLINE real iso_weight_before(const iso_adams *const table, const real h, const uint8_t j, const uint8_t end)
{
    return j < end ? h * iso_whole(table->b[j]) / iso_whole(table->over) : R(0.0);
}

/* |h b[j] / over|: the weight of a derivative. In an Adams method the signs of the derivatives before the end of a step
 * alternate. The last weight is h less the others: otherwise their rounding errors would add a drift to every state, an
 * epsilon of its motion. */
ISO_INLINE real iso_weight(const iso_adams *const table, const real h, const uint8_t j)
{
    real weight = iso_weight_before(table, h, j, ISO_ADAMS_DERIVATIVES);
    if (j + 1 == ISO_ADAMS_DERIVATIVES || table->b[j + 1] == 0) {
        weight = h - iso_weight_before(table, h, 0, j) - iso_weight_before(table, h, 1, j) -
                 iso_weight_before(table, h, 2, j) - iso_weight_before(table, h, 3, j) -
                 iso_weight_before(table, h, 4, j);
    }
    return table->b[j] < 0 ? -weight : weight;
}

/* Adds a derivative f to the sums that an Adams method keeps instead of derivatives:
 *
 *     sums[0] = w[first] f - sums[1],   sums[1] = w[first + 1] f - sums[2], ...,   sums[terms - 1] = w[first + terms -
 * 1] f
 *
 * Then sums[0] is the part of the next step that the derivatives so far contribute. This form has as many products and
 * sums as the formula in the derivatives, but it moves no data: the transposed form of a filter, Oppenheim and Schafer
 * (2010), Discrete-Time Signal Processing, 6.4. After `terms` derivatives the old sums have no influence. sums[terms
 * n]. */
ISO_INLINE void iso_take_derivative(const iso_adams *const table, const uint8_t first, const uint8_t terms,
                                    const real h, const size_t n, const real *const derivative, real *const sums)
{
    ISO_UNROLL
    for (uint8_t j = 0; j < terms; j++) {
        const real weight = iso_weight(table, h, (uint8_t)(first + j));
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            real sum = weight * derivative[s];
            if (j + 1U < terms) {
                sum -= sums[(j + 1U) * n + s];
            }
            sums[j * n + s] = sum;
        }
    }
}

/* The largest of |a| and |b|. */
static inline real iso_larger(const real a, const real b)
{
    return iso_max(iso_abs(a), iso_abs(b));
}

/* 3 h / 60: the weight of the outer derivatives of a centred check. */
static inline real iso_centred_weight(const real h)
{
    return h / R(20.0);
}

/* The local error of the last step, without an evaluation: the difference between its increment and that of the
 * implicit Adams method with `derivative` at the end of that step and `checked` derivatives before it. Exact to
 * h^(checked + 2). Centred: of the step before the last, exact to h^6. error[n], or NULL. Returns the largest. */
static inline real iso_check(const iso_history *const history, const real h, const real *const derivative,
                             real *const error)
{
    real largest = R(0.0);
    if (history->checked > 0) {
        const real weight =
            history->centred ? iso_centred_weight(h) : iso_weight(&iso_table_am[history->checked], h, 0);
        ISO_UNROLL
        for (size_t s = 0; s < history->n; s++) {
            const real e = history->check[s] - weight * derivative[s];
            largest = iso_larger(largest, e);
            if (error != NULL) {
                error[s] = e;
            }
        }
    }
    return largest;
}

/* Prepares the next check, before the states advance: adds the newest derivative to its sums. */
ISO_INLINE void iso_keep_derivative(const iso_history *const history, const real h, const real *const derivative)
{
    const size_t n = history->n;
    if (!history->centred) {
        iso_take_derivative(&iso_table_am[history->checked], 1, history->checked, h, n, derivative, history->check);
        return;
    }
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real outer = iso_centred_weight(h) * derivative[s];
        const real inner = R(9.0) * outer;
        history->check[s] = history->check[n + s] - inner;
        history->check[n + s] = history->check[2 * n + s] - inner;
        history->check[2 * n + s] = -outer;
    }
}

/* After a step: a change of a state beside its method is a part of the increment that the next check sees. */
static inline void iso_check_moved(const iso_history *const history, const size_t s, const real moved)
{
    if (history->centred) {
        iso_check_centred(history, s, moved);
    } else if (history->checked > 0) {
        history->check[s] += moved;
    }
}

#endif
