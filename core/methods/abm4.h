/* Adams-Bashforth-Moulton of order four: predict, then evaluate and correct, P(EC)^m or P(EC)^m E. */
#ifndef ISO_CORE_METHODS_ABM4_H
#define ISO_CORE_METHODS_ABM4_H

#include "core/methods/ab4.h"

/* Milne (1926), Amer. Math. Monthly 33, 455-460: the local error of the corrector is minus this part of the difference
 * corrector - predictor; from the error constants 251/720 and -19/720. */
static const iso_adams iso_table_milne = {.b = {19}, .over = 270};

/* Sums kept: the parts of the predictor, then of the corrector, that the derivatives so far contribute. */
enum {
    ISO_ABM4_PREDICTOR = ISO_AB4_STEPS,
    ISO_ABM4_CORRECTOR = ISO_AB4_STEPS - 1,
    ISO_ABM4_SUMS = ISO_ABM4_PREDICTOR + ISO_ABM4_CORRECTOR,
};

ISO_INLINE void iso_abm4_take_derivative(const iso_history *const history, const real h, const real *const derivative)
{
    const size_t n = history->n;
    iso_take_derivative(&iso_table_ab4, 0, ISO_ABM4_PREDICTOR, h, n, derivative, history->past);
    iso_take_derivative(&iso_table_am[3], 1, ISO_ABM4_CORRECTOR, h, n, derivative,
                        history->past + ISO_ABM4_PREDICTOR * n);
}

/* (1 - 19/270) w, see below. */
ISO_INLINE real iso_abm4_late_weight(const real h)
{
    const real share = R(1.0) - iso_whole(iso_table_milne.b[0]) / iso_whole(iso_table_milne.over);
    return share * iso_weight(&iso_table_am[3], h, 0);
}

/* With smooth inputs the last evaluation of a step is made at the start of the next one, with the sample that has come
 * by then. Where steps are checked, it also shows the error of the corrector's extrapolated inputs: the corrector errs
 * by 19/270 (corrector - predictor) + (1 - 19/270) w (f extrapolated - f), w its weight of that derivative. The first
 * two of these terms are kept for the next step, behind the sums. */
ISO_INLINE void iso_abm4_begin(iso_step *const step)
{
    const iso_history *const history = step->history;
    const real weight = iso_abm4_late_weight(step->h);
    const real *const kept = history->past + ISO_ABM4_SUMS * history->n;
    real *const derivative = step->work;
    iso_evaluate(step, derivative, history->x);
    step->error = R(0.0);
    if (step->checked) {
        ISO_UNROLL
        for (size_t s = 0; s < history->n; s++) {
            step->error = iso_larger(step->error, kept[s] - weight * derivative[s]);
        }
    }
    iso_abm4_take_derivative(history, step->h, derivative);
}

/* Predict, then evaluate and correct `corrections` times, then evaluate once more if `evaluate_last`. Local error
 * -19/720 h^5 x^(5), estimated by Milne: 19/270 of the largest difference between predictor and corrector.
 * history->past[ISO_ABM4_SUMS n], n more where `late` steps are checked, work[2 n]. */
ISO_INLINE void iso_abm4_correct(iso_step *const step, const uint8_t corrections, const bool evaluate_last)
{
    const iso_history *const history = step->history;
    const size_t n = history->n;
    const real *const predicted = history->past;
    const real *const corrector = history->past + ISO_ABM4_PREDICTOR * n;
    const real weight = iso_weight(&iso_table_am[3], step->h, 0);
    const real milne = iso_whole(iso_table_milne.b[0]) / iso_whole(iso_table_milne.over);
    const bool late = evaluate_last && step->degree > 0;
    real *const derivative = step->work;
    real *const at = step->work + n;
    real error = R(0.0);

    if (late) {
        iso_abm4_begin(step);
    }
    const real *const u = iso_inputs_at(step, R(1.0));

    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        at[s] = history->x[s] + predicted[s];
    }
    ISO_UNROLL
    for (uint8_t i = 1; i < corrections; i++) {
        step->f(derivative, at, u, step->p);
        ISO_UNROLL
        for (size_t s = 0; s < n; s++) {
            at[s] = history->x[s] + (weight * derivative[s] + corrector[s]);
        }
    }
    step->f(derivative, at, u, step->p);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real corrected = weight * derivative[s] + corrector[s];
        error = iso_larger(error, corrected - predicted[s]);
        if (late && step->checked) {
            history->past[ISO_ABM4_SUMS * n + s] =
                milne * (corrected - predicted[s]) + iso_abm4_late_weight(step->h) * derivative[s];
        }
        if (step->errors != NULL) {
            step->errors[s] = milne * (corrected - predicted[s]);
        }
        iso_advance(history, s, corrected);
    }
    if (late) {
        return;
    }
    if (evaluate_last) {
        iso_evaluate(step, derivative, history->x);
    }
    iso_abm4_take_derivative(history, step->h, derivative);
    step->error = milne * error;
}

ISO_INLINE void iso_abm4_step(iso_step *const step)
{
    iso_abm4_correct(step, 1, true);
}

/* The derivatives until now; or where a step begins with that of now, those before it, and an error of zero. */
static inline void iso_abm4_fill(const iso_step *const step, const bool late)
{
    const iso_history *const history = step->history;
    const real *const derivatives = iso_walk_back(step, ISO_AB4_STEPS, !late);
    for (uint8_t past = ISO_AB4_STEPS; past-- > 0;) {
        iso_abm4_take_derivative(history, step->h, derivatives + past * history->n);
    }
    if (late && step->checked) {
        iso_evaluate(step, step->work, history->x);
        for (size_t s = 0; s < history->n; s++) {
            history->past[ISO_ABM4_SUMS * history->n + s] = iso_abm4_late_weight(step->h) * step->work[s];
        }
    }
}

static inline void iso_abm4_prime(iso_step *const step)
{
    iso_abm4_fill(step, step->degree > 0);
}

/* The columns of core/methods/table.h. */
#define ISO_ABM4_ORDER(r) 4
#define ISO_ABM4_STAGES(r) 0
#define ISO_ABM4_TABLEAU NULL
#define ISO_ABM4_EVALUATIONS(r) 2
#define ISO_ABM4_SOLUTIONS(r) 0
#define ISO_ABM4_PAST(r) (ISO_ABM4_SUMS + ISO_IS_LATE(r))
#define ISO_ABM4_WORK(r) 2
#define ISO_ABM4_PRIME(r) ISO_PRIME_VECTORS
#define ISO_ABM4_PRIMES(r) iso_abm4_prime
#define ISO_ABM4_SUMS(r) (7 + ISO_IS_CHECKED(r) + ISO_IS_LATE(r))
#define ISO_ABM4_PRODUCTS(r) (8 + 2 * ISO_IS_LATE(r))
#define ISO_ABM4_KIND(r) ISO_CORRECTING

#endif
