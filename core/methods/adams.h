/* Adams predictor-corrector (PECE) of variable order, one to four, whose step is halved and doubled.
 *
 * A tick H consists of sub-steps h = H / 2^level. The rest of the tick is counted in whole sub-steps: halving the step
 * doubles the count, doubling the step halves an even count. So every tick ends exactly, without a sum of times. At
 * most `budget` sub-steps are tried in a tick, of two evaluations each. If the budget does not allow to repeat a
 * sub-step, it is accepted in spite of its error, and counted.
 *
 * The history is a polynomial at the end of the last sub-step, in rows z_j = h^j x^(j) / j!. Another step scales them
 * by powers of two. Nordsieck (1962), Math. Comp. 16, 22-49; Gear (1971), Numerical Initial Value Problems in Ordinary
 * Differential Equations, ch. 9; Hairer, Norsett, Wanner (1993), Solving Ordinary Differential Equations I, III.6. The
 * rows of order q are those of the polynomial whose derivatives are those at the q ends of sub-steps until now; the
 * last correction has the derivative at one end more. So the order can be exchanged without a loss, and with it the
 * step: the polynomial of one order more is scaled, and has the derivatives of the past that even steps of the new size
 * would have had, to the leading term of the error. The constants of the estimate thus hold in every sub-step. Rows
 * above the order are zero, so that a sub-step costs the same at every order. Only loops over rows are unrolled: those
 * over states are many, and code would grow with their product.
 */
#ifndef ISO_CORE_METHODS_ADAMS_H
#define ISO_CORE_METHODS_ADAMS_H

#include "core/methods/step.h"

enum {
    ISO_ADAMS_ORDERS = 4,
    ISO_ADAMS_ROWS = ISO_ADAMS_ORDERS + 1, /* rows behind the states: z_1 to z_4, and the last correction */
    ISO_ADAMS_LEVELS = 30,                 /* the largest level_max */
    ISO_ADAMS_BUDGET = 8,                  /* default */
    ISO_ADAMS_LEVEL_MAX = 10,              /* default */
    ISO_ADAMS_BUDGET_HOST = 1 << 30,       /* practically no limit */
};

enum { ISO_ADAMS_VECTORS = 4, ISO_ADAMS_ERRORS = 3 }; /* of work space; the last one has the errors of a tick */

/* The tolerance of a scene: the local error of a sub-step may be T (1 + |x|) in each state x, that at its start. */
#ifndef ISO_ADAMS_TOLERANCE
#define ISO_ADAMS_TOLERANCE R(1e-6)
#endif

/* Defaults of the sub-steps of a tick, and of how often a sub-step may be half of the one before. */
#ifndef ISO_ADAMS_SUBSTEPS
#define ISO_ADAMS_SUBSTEPS ISO_ADAMS_BUDGET
#define ISO_ADAMS_HALVINGS ISO_ADAMS_LEVEL_MAX
#endif

/* The estimate for a state that is not finite: infinity. */
#define ISO_ADAMS_FAILED iso_real_of(ISO_EXPONENT_BITS)

typedef struct iso_adams_options {
    real tolerance_absolute; /* above zero; infinity: the step is never reduced */
    real tolerance_relative; /* the local error may be tolerance_absolute + tolerance_relative |x| */
    uint32_t budget;         /* sub-steps that may be tried in a tick, at least 1, of two evaluations each */
    bool driven;             /* inputs change from tick to tick: a tick begins with an evaluation more */
    uint8_t level_max;       /* at most ISO_ADAMS_LEVELS */
} iso_adams_options;

/* For equations without options. */
static const iso_adams_options iso_adams_default = {
    .tolerance_absolute = ISO_ADAMS_TOLERANCE,
    .tolerance_relative = ISO_ADAMS_TOLERANCE,
    .budget = ISO_ADAMS_SUBSTEPS,
    .driven = true,
    .level_max = ISO_ADAMS_HALVINGS,
};

/* Row j of the correction of order q, by that of row 1: its polynomial vanishes one step before, and its derivative at
 * the q - 1 steps before. Row 0 is the weight of the newest derivative in the implicit Adams formula of order q; the
 * weight of the next order less this one is the error constant. Gear (1971), table 9.2 and eq. 7.33; Hairer, Norsett,
 * Wanner (1993), eq. III.6.13 and table III.2.1. Of order 6 there is row 0 only. */
static const real iso_table_nordsieck[ISO_ADAMS_ORDERS + 3][ISO_ADAMS_ORDERS + 1] = {
    [1] = {R(1.0), R(1.0)},
    [2] = {R(1.0) / R(2.0), R(1.0), R(1.0) / R(2.0)},
    [3] = {R(5.0) / R(12.0), R(1.0), R(3.0) / R(4.0), R(1.0) / R(6.0)},
    [4] = {R(3.0) / R(8.0), R(1.0), R(11.0) / R(12.0), R(1.0) / R(3.0), R(1.0) / R(24.0)},
    [5] = {R(251.0) / R(720.0), R(1.0), R(25.0) / R(24.0), R(35.0) / R(72.0), R(5.0) / R(48.0)},
    [6] = {R(95.0) / R(288.0)},
};

/* A tick in progress. */
typedef struct iso_adams_run {
    const iso_adams_options *options;
    iso_adams_state *state;
    const iso_history *history; /* its `past` has the rows */
    iso_derivative *f;
    const real *u;
    const real *p;
    real h_tick;
    uint32_t remaining; /* sub-steps of the present size to the end of the tick */
    uint32_t left;      /* of the budget; never less than remaining */
    real refused;       /* the estimate of the last try if it was rejected, else zero */

    /* Work space, [n] each: */
    real *derivative; /* or the correction of row 1 */
    real *at;         /* the predicted state; then 1 / (its allowed error) */
    real *increment;  /* as predicted; then how it is corrected */
    real *error;      /* the local error of the tick so far */
} iso_adams_run;

static inline real iso_adams_step_size(const iso_adams_run *const run)
{
    return run->h_tick / (real)((uint32_t)1 << run->state->level);
}

/* 1 / (the allowed error of state s). */
static inline real iso_adams_weight(const iso_adams_run *const run, const size_t s)
{
    const iso_adams_options *const o = run->options;
    return R(1.0) / (o->tolerance_absolute + o->tolerance_relative * iso_abs(run->history->x[s]));
}

/* |e| / (the allowed error of a state), for 1 / (the allowed error). */
static inline real iso_adams_ratio(const real e, const real weight)
{
    const real ratio = iso_abs(e) * weight;
    return iso_select(iso_not_finite(ratio), ISO_ADAMS_FAILED, ratio);
}

ISO_INLINE void iso_adams_evaluate(const iso_adams_run *const run, const real *const x)
{
    run->f(run->derivative, x, run->u, run->p);
    run->state->evaluations++;
}

/* The polynomial of state s one step further, by Pascal's triangle; z[0] is the increment of x. */
static inline void iso_adams_predict(const iso_history *const history, const size_t s, real z[ISO_ADAMS_ORDERS + 1])
{
    z[0] = R(0.0);
    ISO_UNROLL
    for (size_t j = 1; j <= ISO_ADAMS_ORDERS; j++) {
        z[j] = history->past[(j - 1) * history->n + s];
    }
    ISO_UNROLL
    for (size_t k = 0; k < ISO_ADAMS_ORDERS; k++) {
        ISO_UNROLL
        for (size_t j = ISO_ADAMS_ORDERS; j > k; j--) {
            z[j - 1] += z[j];
        }
    }
}

/* The last correction of row 1. */
static inline real *iso_adams_last(const iso_history *const history)
{
    return history->past + ISO_ADAMS_ORDERS * history->n;
}

/* Adds the last correction to the rows of order q: this gives those of order q + 1, up to row `rows`; with a sign of -1
 * it goes back. The correction is the derivative at one more end of a sub-step, less that of the polynomial there. */
static inline void iso_adams_extend(const iso_adams_run *const run, const size_t q, const real sign, const size_t rows)
{
    const size_t n = run->history->n;
    const real *const last = iso_adams_last(run->history);
    for (size_t j = 2; j <= rows; j++) {
        const real part = sign * (iso_table_nordsieck[q + 1][j] - iso_table_nordsieck[q][j]);
        real *const row = run->history->past + (j - 1) * n;
        for (size_t s = 0; s < n; s++) {
            row[s] += part * last[s];
        }
    }
}

/* The rows for a step of `factor` times the present one, a power of two. The last correction goes with its q + 1. */
static inline void iso_adams_scale(const iso_adams_run *const run, const real factor)
{
    const size_t n = run->history->n;
    const size_t q = run->state->order;
    real *const last = iso_adams_last(run->history);
    real power = factor;
    iso_adams_extend(run, q, R(1.0), q);
    for (size_t j = 1; j <= q; j++) {
        real *const row = run->history->past + (j - 1) * n;
        for (size_t s = 0; s < n; s++) {
            row[s] *= power;
        }
        power *= factor;
    }
    for (size_t s = 0; s < n; s++) {
        last[s] *= power;
    }
    iso_adams_extend(run, q, R(-1.0), q);
    run->state->age = run->state->age > 0;
}

/* Removes the last correction: it is unknown, or the step is too large for the motion, so that the past that follows
 * from it would grow where steps change in every tick. */
static inline void iso_adams_forget(const iso_adams_run *const run)
{
    memset(iso_adams_last(run->history), 0, run->history->n * sizeof *run->history->past);
    run->state->age = 0;
}

static inline void iso_adams_double(iso_adams_run *const run)
{
    iso_adams_scale(run, R(2.0));
    run->state->level--;
    run->remaining /= 2;
}

static inline void iso_adams_halve(iso_adams_run *const run)
{
    iso_adams_scale(run, R(0.5));
    run->state->level++;
    run->state->overdue = false;
    run->remaining *= 2;
}

/* Whether steps of half the size reach the end of the tick within the rest of the budget. */
static inline bool iso_adams_can_halve(const iso_adams_run *const run)
{
    return run->state->level < run->options->level_max && 2 * run->remaining <= run->left;
}

/* Sets the first row for a new derivative. */
static inline void iso_adams_take_derivative(const iso_adams_run *const run)
{
    const real h = iso_adams_step_size(run);
    iso_adams_evaluate(run, run->history->x);
    for (size_t s = 0; s < run->history->n; s++) {
        run->history->past[s] = h * run->derivative[s];
    }
}

/* Forgets the past: order one, and a step so small that its error h^2 x'' / 2 would be a quarter of the tolerance if
 * the derivative changed by itself within a tick. The step is not larger than the present one. */
static inline void iso_adams_begin(iso_adams_run *const run)
{
    iso_adams_state *const state = run->state;
    real ratio = R(0.0);
    memset(run->history->past, 0, ISO_ADAMS_ROWS * run->history->n * sizeof *run->history->past);
    iso_adams_take_derivative(run);
    state->order = 1;
    state->age = 0;
    state->starting = true;
    for (size_t s = 0; s < run->history->n; s++) {
        ratio =
            iso_max(ratio, iso_adams_ratio(iso_adams_step_size(run) * run->derivative[s], iso_adams_weight(run, s)));
    }
    /* ratio is h |x'|, and h^2 |x'| / H is needed. */
    ratio /= (real)((uint32_t)1 << state->level);
    while (R(2.0) * ratio > R(1.0) && iso_adams_can_halve(run)) {
        iso_adams_halve(run);
        ratio *= R(0.25);
    }
}

/* Predicts and evaluates. Returns the leading term of the local error over the tolerance, and leaves the state as it
 * is; the corrections of row 1 stand in run->derivative. */
static inline real iso_adams_try(const iso_adams_run *const run)
{
    const iso_history *const history = run->history;
    const size_t q = run->state->order;
    const real h = iso_adams_step_size(run);
    const real part = iso_table_nordsieck[q + 1][0] - iso_table_nordsieck[q][0];
    real z[ISO_ADAMS_ORDERS + 1];
    real largest = R(0.0);
    for (size_t s = 0; s < history->n; s++) {
        iso_adams_predict(history, s, z);
        run->increment[s] = z[0];
        run->at[s] = history->x[s] + z[0];
    }
    iso_adams_evaluate(run, run->at);
    for (size_t s = 0; s < history->n; s++) {
        iso_adams_predict(history, s, z);
        run->derivative[s] = h * run->derivative[s] - z[1];
        run->at[s] = iso_adams_weight(run, s);
        largest = iso_max(largest, iso_adams_ratio(part * run->derivative[s], run->at[s]));
    }
    return largest;
}

/* Estimates of the local error over the tolerance: of the order below, of the present one, and of the order above. */
typedef struct iso_adams_estimates {
    real lower;
    real present;
    real higher;
} iso_adams_estimates;

/* Corrects, evaluates again and moves the rows on. The last correction is h^(q+1) x^(q+1), its difference to the one
 * before that of one order more, z_q the one of an order less. The error is the difference of the increment to the
 * implicit Adams formula of two orders more, with the derivative evaluated last; of one order more where no earlier
 * correction is known. */
static inline iso_adams_estimates iso_adams_correct(const iso_adams_run *const run)
{
    const iso_history *const history = run->history;
    const size_t n = history->n;
    const size_t q = run->state->order;
    const real *const l = iso_table_nordsieck[q];
    const real formula = iso_table_nordsieck[q + 1][0];
    const real below = (l[0] - iso_table_nordsieck[q - 1][0]) / l[q];
    const real above = run->state->age > 0 ? iso_table_nordsieck[q + 2][0] - formula : R(0.0);
    const real h = iso_adams_step_size(run);
    real *const last = iso_adams_last(history);
    iso_adams_estimates estimates = {R(0.0), R(0.0), R(0.0)};
    for (size_t s = 0; s < n; s++) {
        const real correction = l[0] * run->derivative[s];
        iso_advance(history, s, run->increment[s] + correction);
        run->increment[s] = correction;
    }
    iso_adams_evaluate(run, history->x);
    for (size_t s = 0; s < n; s++) {
        real z[ISO_ADAMS_ORDERS + 1];
        iso_adams_predict(history, s, z);
        const real derivative = h * run->derivative[s];
        const real e = derivative - z[1];
        const real next = above * (e - last[s]);
        const real error = formula * e - run->increment[s] + next;
        history->past[s] = derivative;
        ISO_UNROLL
        for (size_t j = 2; j <= ISO_ADAMS_ORDERS; j++) {
            history->past[(j - 1) * n + s] = z[j] + l[j] * e;
        }
        const real weight = run->at[s];
        estimates.lower = iso_max(estimates.lower, iso_abs(below * history->past[(q - 1) * n + s]) * weight);
        estimates.present = iso_max(estimates.present, iso_adams_ratio(error, weight));
        estimates.higher = iso_max(estimates.higher, iso_abs(next) * weight);
        run->error[s] += error;
        last[s] = e;
    }
    return estimates;
}

/* One order more. */
static inline void iso_adams_raise(const iso_adams_run *const run)
{
    const size_t q = run->state->order;
    iso_adams_extend(run, q, R(1.0), q + 1);
    iso_adams_forget(run);
    run->state->order++;
}

/* One order less; its last correction follows from the row that is removed. */
static inline void iso_adams_lower(const iso_adams_run *const run)
{
    const size_t n = run->history->n;
    const size_t q = run->state->order;
    real *const row = run->history->past + (q - 1) * n;
    real *const last = iso_adams_last(run->history);
    for (size_t s = 0; s < n; s++) {
        last[s] = row[s] / iso_table_nordsieck[q][q];
        row[s] = R(0.0);
    }
    iso_adams_extend(run, q - 1, R(-1.0), q - 1);
    run->state->order--;
    run->state->age = 1;
}

/* Order and step of the next sub-step: twice the step where that keeps the error below half the tolerance, else the
 * order with the least error; a lower one only for a quarter of it, and where it is not so small. The error may be
 * small because it passes through zero: until twice the step is done it will have changed by some two of its next term.
 * Each is left alone until the corrections come from as many sub-steps as it needs. At a start the order is raised once
 * the derivatives that it takes come from sub-steps of the order below: those of an order less are wrong by more than
 * the terms that it looks at. After Shampine and Gordon (1975), Computer Solution of Ordinary Differential Equations,
 * ch. 7. */
static inline void iso_adams_adapt(iso_adams_run *const run, const iso_adams_estimates e)
{
    iso_adams_state *const state = run->state;
    const real growth = (real)(4 << state->order); /* 2^(order + 1), and the half */
    const bool grows = growth * (e.present + R(2.0) * e.higher) <= R(1.0);
    state->age = (uint8_t)(state->age + (state->age < UINT8_MAX));
    state->overdue = state->overdue && e.present > R(1.0);
    if (state->starting) {
        if (state->age >= state->order) {
            iso_adams_raise(run);
            state->starting = state->order < ISO_ADAMS_ORDERS;
        }
    } else if (grows && state->age > 2 && state->level > 0 && run->remaining % 2 == 0) {
        iso_adams_double(run);
    } else if (state->age > state->order && state->order < ISO_ADAMS_ORDERS && e.higher < e.present) {
        iso_adams_raise(run);
    } else if (state->age > state->order && state->order > 1 && R(4.0) * e.lower < e.present && !grows) {
        iso_adams_lower(run);
    }
}

/* Halves a sub-step that was rejected. The correction that takes the past to the new size is the one at which the
 * derivative half a step back is right to one order more: between the refused one, of derivatives 1 to 1 - q, and the
 * last one, of derivatives 0 to -q, whose polynomials err there by 3/2 to q - 1/2. */
static inline void iso_adams_halve_refused(iso_adams_run *const run)
{
    const real weight = run->state->age > 0 ? R(1.5) / (real)(run->state->order + 1) : R(0.0);
    real *const last = iso_adams_last(run->history);
    for (size_t s = 0; s < run->history->n; s++) {
        last[s] = run->derivative[s] + weight * (last[s] - run->derivative[s]);
    }
    iso_adams_halve(run);
}

/* Decides about a sub-step whose error is too large: true if it must be tried again. Halving divides the estimate by
 * 2^(order + 1), at least by 4, if the motion is smooth, and by 2 if the derivative has a discontinuity. So an estimate
 * of more than a third of the one before, at twice the step, means a discontinuity. */
static inline bool iso_adams_reject(iso_adams_run *const run, const real estimate)
{
    iso_adams_state *const state = run->state;
    const bool fresh = state->starting && state->order == 1;
    const bool discontinuity = run->refused > R(0.0) && estimate > run->refused / R(3.0) && !fresh;
    if (discontinuity && run->remaining <= run->left) {
        state->restarts++;
        iso_adams_begin(run);
    } else if (iso_adams_can_halve(run)) {
        state->starting = fresh;
        iso_adams_halve_refused(run);
    } else {
        state->budget_bound++;
        state->overdue = true;
        return false;
    }
    state->rejected++;
    return true;
}

/* Halves a sub-step whose error was accepted for want of a budget. */
ISO_INLINE void iso_adams_catch_up(iso_adams_run *const run)
{
    if (run->state->overdue && iso_adams_can_halve(run)) {
        iso_adams_forget(run);
        iso_adams_halve(run);
    }
}

/* Tries a sub-step, and accepts it if its error allows. A state that is not finite ends the tick. */
static inline void iso_adams_attempt(iso_adams_run *const run)
{
    iso_adams_catch_up(run);
    run->left--;
    const real estimate = iso_adams_try(run);
    if (estimate > R(1.0) && iso_adams_reject(run, estimate)) {
        run->refused = estimate;
    } else {
        const iso_adams_estimates estimates = iso_adams_correct(run);
        run->refused = R(0.0);
        run->state->substeps++;
        if (iso_not_finite(estimates.present) == 0) {
            run->remaining--;
            iso_adams_adapt(run, estimates);
        } else {
            run->remaining = 0;
        }
    }
}

static inline const iso_adams_options *iso_adams_options_of(const iso_step *const step)
{
    return step->equations->adams == NULL ? &iso_adams_default : step->equations->adams;
}

/* The interface of every method; step->progress is the start of an iso_adams_state. */
ISO_INLINE iso_adams_run iso_adams_run_of(const iso_step *const step)
{
    const size_t n = step->history->n;
    const iso_adams_options *const options = iso_adams_options_of(step);
    iso_adams_state *const state = (iso_adams_state *)step->progress;
    return (iso_adams_run){
        .options = options,
        .state = state,
        .history = step->history,
        .f = step->f,
        .u = step->u,
        .p = step->p,
        .h_tick = step->h,
        .remaining = (uint32_t)1 << state->level,
        .left = options->budget,
        .refused = R(0.0),
        .derivative = step->work,
        .at = step->work + n,
        .increment = step->work + 2 * n,
        .error = step->work + ISO_ADAMS_ERRORS * n,
    };
}

/* Before the first tick, and after a discontinuity: starts from the states in the history, whose past is
 * [ISO_ADAMS_ROWS n]. One evaluation. The counters go on. work[ISO_ADAMS_VECTORS n]. */
ISO_INLINE void iso_adams_prime(iso_step *const step)
{
    iso_adams_state *const state = (iso_adams_state *)step->progress;
    state->level = 0;
    state->overdue = false;
    iso_adams_run run = iso_adams_run_of(step);
    iso_adams_begin(&run);
}

/* Advances the states by one tick with p held; smooth inputs are those at the end of each sub-step. The error is the
 * largest part of that of the tick, absolute: the estimates of its sub-steps, added up state by state.
 * work[ISO_ADAMS_VECTORS n]. */
ISO_INLINE void iso_adams_step(iso_step *const step)
{
    const iso_history *const history = step->history;
    const iso_adams_options *const options = iso_adams_options_of(step);
    const iso_adams_state *const state = (const iso_adams_state *)step->progress;
    iso_adams_run run = iso_adams_run_of(step);
    real largest = R(0.0);
    memset(run.error, 0, history->n * sizeof *run.error);
    if (run.remaining > run.left && state->overdue) {
        iso_adams_forget(&run);
    }
    while (run.remaining > run.left) {
        iso_adams_double(&run);
    }
    if (options->driven) {
        iso_adams_take_derivative(&run);
    }
    while (run.remaining > 0) {
        if (step->degree > 0) {
            iso_adams_catch_up(&run);
            run.u = iso_inputs_at(step, R(1.0) - (real)(run.remaining - 1) / (real)((uint32_t)1 << state->level));
        }
        iso_adams_attempt(&run);
    }
    for (size_t s = 0; s < history->n; s++) {
        largest = iso_larger(largest, run.error[s]);
    }
    step->error = largest;
    for (size_t s = 0; s < history->n && step->errors != NULL; s++) {
        step->errors[s] = -step->work[ISO_ADAMS_ERRORS * history->n + s];
    }
}

/* The columns of core/methods/table.h. */
#define ISO_ADAMS_ORDER(r) 4
#define ISO_ADAMS_STAGES(r) 0
#define ISO_ADAMS_TABLEAU NULL
#define ISO_ADAMS_EVALUATIONS(r) 2
#define ISO_ADAMS_SOLUTIONS(r) 0
#define ISO_ADAMS_PAST(r) ISO_ADAMS_ROWS
#define ISO_ADAMS_WORK(r) ISO_ADAMS_VECTORS
#define ISO_ADAMS_PRIME(r) ISO_ADAMS_VECTORS
#define ISO_ADAMS_PRIMES(r) iso_adams_prime
#define ISO_ADAMS_SUMS(r) 0
#define ISO_ADAMS_PRODUCTS(r) 0
#define ISO_ADAMS_KIND(r) ISO_VARYING

#endif
