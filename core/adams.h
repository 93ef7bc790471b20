/* Adams predictor-corrector (PECE) of variable order, one to four, whose step is halved and doubled.
 *
 * A tick H is walked in sub-steps h = H / 2^level. What is left of it is counted in whole sub-steps: halving doubles the
 * count, doubling halves an even one, so that every tick ends where it should without a sum of times. At most `budget`
 * sub-steps are tried in a tick, of two evaluations each; one that would be too many to repeat is kept in spite of its
 * error, and counted.
 *
 * The past is kept as a polynomial at the end of the last sub-step, in rows z_j = h^j x^(j) / j!: another step scales
 * them by powers of two, without rounding. Nordsieck (1962), Math. Comp. 16, 22-49; Gear (1971), Numerical Initial Value
 * Problems in Ordinary Differential Equations, ch. 9; Hairer, Norsett, Wanner (1993), Solving Ordinary Differential
 * Equations I, III.6. Rows above the order are zero, so that a sub-step costs the same at every order. Only
 * loops over rows are unrolled: those over states are many, and code would grow with their product.
 */
#ifndef ISO_CORE_ADAMS_H
#define ISO_CORE_ADAMS_H

#include <stdbool.h>

#include "core/trail.h"

enum {
    ISO_ADAMS_ORDERS = 4,
    ISO_ADAMS_ROWS = ISO_ADAMS_ORDERS + 1, /* kept behind the states: z_1 to z_4, and the last correction */
    ISO_ADAMS_LEVELS = 30,                 /* the largest level_max */
    ISO_ADAMS_BUDGET = 8,                  /* where nothing is said */
    ISO_ADAMS_LEVEL_MAX = 10,              /* ... */
    ISO_ADAMS_BUDGET_HOST = 1 << 30,       /* as good as none */
};

/* The local error of a sub-step may be this, and this times |x| more, where nothing is said. */
#define ISO_ADAMS_TOLERANCE R(1e-6)

/* The estimate of what is not finite, or is not known: infinite. */
#define ISO_ADAMS_FAILED iso_real_of(ISO_EXPONENT_BITS)

/* Reals of x, the states and what is kept behind them, and of work space. */
#define ISO_ADAMS_STATE(n) ((1 + ISO_ADAMS_ROWS) * (n))
#define ISO_ADAMS_WORK(n) (4 * (n))

typedef struct iso_adams_options {
    real tolerance_absolute; /* above zero; infinite: the steps are never smaller than need be */
    real tolerance_relative;
    uint32_t budget; /* sub-steps that may be tried in a tick, at least 1; evaluations are at most twice that, */
    bool driven;     /* and one more where inputs change from tick to tick: the slope at its start is evaluated anew */
    uint8_t level_max; /* at most ISO_ADAMS_LEVELS */
} iso_adams_options;

/* How a run goes. Zeros before the first start. */
typedef struct iso_adams_state {
    uint8_t order;
    uint8_t level;
    uint8_t age;   /* sub-steps since order or level changed, up to 255 */
    bool starting; /* order and step grow with every sub-step */
    bool overdue;  /* the step is too large, but the budget did not allow a smaller one */

    uint32_t substeps;     /* taken */
    uint32_t rejected;     /* tried, and found to be too large */
    uint32_t budget_bound; /* of those taken: with an error above the tolerance, as budget or level_max wanted it */
    uint32_t restarts;     /* since the slope jumped */
    uint32_t evaluations;
} iso_adams_state;

/* Row j of the correction of order q is l[j] / over times the correction of row 1. The polynomial of the l vanishes one
 * step before and its slope at the q - 1 steps before. error / error_over is that part of the correction which is the
 * local error, the constant of the implicit Adams formula. Gear (1971), table 9.2 and eq. 7.33; Hairer, Norsett, Wanner
 * (1993), eq. III.6.13 and table III.2.1. */
typedef struct iso_nordsieck {
    int8_t l[ISO_ADAMS_ORDERS + 1];
    int8_t over;
    int8_t error;
    int16_t error_over;
} iso_nordsieck;

static const iso_nordsieck iso_table_nordsieck[ISO_ADAMS_ORDERS] = {
    {.l = {1, 1}, .over = 1, .error = 1, .error_over = 2},
    {.l = {1, 2, 1}, .over = 2, .error = 1, .error_over = 12},
    {.l = {5, 12, 9, 2}, .over = 12, .error = 1, .error_over = 24},
    {.l = {9, 24, 22, 8, 1}, .over = 24, .error = 19, .error_over = 720},
};

/* A tick under way. */
typedef struct iso_adams_run {
    const iso_adams_options *options;
    iso_adams_state *state;
    const iso_trail *trail; /* its past are the rows */
    iso_derivative *f;
    const real *u;
    const real *p;
    real h_tick;
    uint32_t remaining; /* sub-steps of the present size to the end of the tick */
    uint32_t left;      /* of the budget; never less than remaining */
    real *slope;        /* [n] work space: the slope, */
    real *at;           /* [n] where it was predicted, */
    real *increment;    /* [n] the predicted increment, */
    real *error;        /* [n] the local error of the tick so far */
} iso_adams_run;

static inline real iso_adams_step_size(const iso_adams_run *const run)
{
    return run->h_tick / (real)((uint32_t)1 << run->state->level);
}

/* |e| over what state s may err. */
static inline real iso_adams_ratio(const iso_adams_run *const run, const size_t s, const real e)
{
    const iso_adams_options *const o = run->options;
    const real ratio = iso_abs(e) / (o->tolerance_absolute + o->tolerance_relative * iso_abs(run->trail->x[s]));
    return iso_select(iso_not_finite(ratio), ISO_ADAMS_FAILED, ratio);
}

static inline void iso_adams_evaluate(const iso_adams_run *const run, const real *const x)
{
    run->f(run->slope, x, run->u, run->p);
    run->state->evaluations++;
}

/* The polynomial of state s one step further, by Pascal's triangle; z[0] is the increment of x. */
static inline void iso_adams_predict(const iso_trail *const trail, const size_t s, real z[ISO_ADAMS_ORDERS + 1])
{
    z[0] = R(0.0);
    ISO_UNROLL
    for (size_t j = 1; j <= ISO_ADAMS_ORDERS; j++) {
        z[j] = trail->past[(j - 1) * trail->n + s];
    }
    ISO_UNROLL
    for (size_t k = 0; k < ISO_ADAMS_ORDERS; k++) {
        ISO_UNROLL
        for (size_t j = ISO_ADAMS_ORDERS; j > k; j--) {
            z[j - 1] += z[j];
        }
    }
}

/* The rows for a step of `factor` times the present one, a power of two. */
static inline void iso_adams_scale(const iso_trail *const trail, const real factor)
{
    real power = R(1.0);
    ISO_UNROLL
    for (size_t j = 0; j < ISO_ADAMS_ORDERS; j++) {
        power *= factor;
        for (size_t s = 0; s < trail->n; s++) {
            trail->past[j * trail->n + s] *= power;
        }
    }
}

static inline void iso_adams_double(iso_adams_run *const run)
{
    iso_adams_scale(run->trail, R(2.0));
    run->state->level--;
    run->state->age = 0;
    run->remaining /= 2;
}

static inline void iso_adams_halve(iso_adams_run *const run)
{
    iso_adams_scale(run->trail, R(0.5));
    run->state->level++;
    run->state->age = 0;
    run->state->overdue = false;
    run->remaining *= 2;
}

/* Whether steps of half the size reach the end of the tick with what is left of the budget. */
static inline bool iso_adams_can_halve(const iso_adams_run *const run)
{
    return run->state->level < run->options->level_max && 2 * run->remaining <= run->left;
}

/* The first row, for a slope that is known anew. */
static inline void iso_adams_take_slope(const iso_adams_run *const run)
{
    const real h = iso_adams_step_size(run);
    iso_adams_evaluate(run, run->trail->x);
    for (size_t s = 0; s < run->trail->n; s++) {
        run->trail->past[s] = h * run->slope[s];
    }
}

/* Forgets the past: order one, and a step so small that its error h^2 x'' / 2 would be a quarter of the tolerance if the
 * slope changed by itself within a tick. The step is not larger than the present one. */
static inline void iso_adams_begin(iso_adams_run *const run)
{
    iso_adams_state *const state = run->state;
    real ratio = R(0.0);
    memset(run->trail->past, 0, ISO_ADAMS_ROWS * run->trail->n * sizeof *run->trail->past);
    iso_adams_take_slope(run);
    state->order = 1;
    state->age = 0;
    state->starting = true;
    for (size_t s = 0; s < run->trail->n; s++) {
        ratio = iso_max(ratio, iso_adams_ratio(run, s, iso_adams_step_size(run) * run->slope[s]));
    }
    /* ratio is h |x'|, and h^2 |x'| / H is asked for. */
    ratio /= (real)((uint32_t)1 << state->level);
    while (R(2.0) * ratio > R(1.0) && iso_adams_can_halve(run)) {
        iso_adams_halve(run);
        ratio *= R(0.25);
    }
}

/* Predicts and evaluates. Returns the estimate of the local error over the tolerance, and leaves the state as it is; the
 * corrections of row 1 stand in run->slope. */
static inline real iso_adams_try(const iso_adams_run *const run)
{
    const iso_trail *const trail = run->trail;
    const iso_nordsieck *const table = &iso_table_nordsieck[run->state->order - 1];
    const real h = iso_adams_step_size(run);
    const real part = (real)table->error / (real)table->error_over;
    real z[ISO_ADAMS_ORDERS + 1];
    real largest = R(0.0);
    for (size_t s = 0; s < trail->n; s++) {
        iso_adams_predict(trail, s, z);
        run->increment[s] = z[0];
        run->at[s] = trail->x[s] + z[0];
    }
    iso_adams_evaluate(run, run->at);
    for (size_t s = 0; s < trail->n; s++) {
        iso_adams_predict(trail, s, z);
        run->slope[s] = h * run->slope[s] - z[1];
        largest = iso_max(largest, iso_adams_ratio(run, s, part * run->slope[s]));
    }
    return largest;
}

/* The estimates of the local error of the orders beside the present one; where there is none, more than can be. */
typedef struct iso_adams_neighbours {
    real lower;
    real higher;
} iso_adams_neighbours;

/* Corrects, evaluates again and moves the rows on. The last correction is h^(q+1) x^(q+1), its difference to the one
 * before that of one order more, z_q the one of an order less. */
static inline iso_adams_neighbours iso_adams_correct(const iso_adams_run *const run)
{
    const iso_trail *const trail = run->trail;
    const size_t n = trail->n;
    const size_t q = run->state->order;
    const iso_nordsieck *const table = &iso_table_nordsieck[q - 1];
    const iso_nordsieck *const below = &iso_table_nordsieck[q > 1 ? q - 2 : 0];
    const iso_nordsieck *const above = &iso_table_nordsieck[q < ISO_ADAMS_ORDERS ? q : q - 1];
    const real h = iso_adams_step_size(run);
    const real part = (real)table->error / (real)table->error_over;
    const real part_below = (real)(below->error * table->over) / (real)(below->error_over * table->l[q]);
    const real part_above = (real)above->error / (real)above->error_over;
    iso_adams_neighbours estimates = {R(0.0), R(0.0)};
    real *const last = trail->past + ISO_ADAMS_ORDERS * n;
    real l[ISO_ADAMS_ORDERS + 1];
    ISO_UNROLL
    for (size_t j = 0; j <= ISO_ADAMS_ORDERS; j++) {
        l[j] = (real)table->l[j] / (real)table->over;
    }
    for (size_t s = 0; s < n; s++) {
        run->error[s] += part * run->slope[s];
        iso_advance(trail, s, run->increment[s] + l[0] * run->slope[s]);
    }
    iso_adams_evaluate(run, trail->x);
    for (size_t s = 0; s < n; s++) {
        real z[ISO_ADAMS_ORDERS + 1];
        iso_adams_predict(trail, s, z);
        const real slope = h * run->slope[s];
        const real e = slope - z[1];
        trail->past[s] = slope;
        ISO_UNROLL
        for (size_t j = 2; j <= ISO_ADAMS_ORDERS; j++) {
            trail->past[(j - 1) * n + s] = z[j] + l[j] * e;
        }
        const real highest = trail->past[(q - 1) * n + s];
        estimates.lower = iso_max(estimates.lower, iso_adams_ratio(run, s, part_below * highest));
        estimates.higher = iso_max(estimates.higher, iso_adams_ratio(run, s, part_above * (e - last[s])));
        last[s] = e;
    }
    estimates.lower = q > 1 ? estimates.lower : ISO_ADAMS_FAILED;
    estimates.higher = q < ISO_ADAMS_ORDERS ? estimates.higher : ISO_ADAMS_FAILED;
    return estimates;
}

/* One order more: its row from the last correction, z_(q+1) = h^(q+1) x^(q+1) / (q+1)!, where l_q is 1 / q!. */
static inline void iso_adams_raise(const iso_adams_run *const run)
{
    const size_t n = run->trail->n;
    const size_t q = run->state->order;
    const iso_nordsieck *const table = &iso_table_nordsieck[q - 1];
    const real part = (real)table->l[q] / (real)(table->over * (int)(q + 1));
    for (size_t s = 0; s < n; s++) {
        run->trail->past[q * n + s] = part * run->trail->past[ISO_ADAMS_ORDERS * n + s];
    }
    run->state->order++;
    run->state->age = 0;
}

static inline void iso_adams_lower(const iso_adams_run *const run)
{
    const size_t n = run->trail->n;
    run->state->order--;
    run->state->age = 0;
    memset(run->trail->past + run->state->order * n, 0, n * sizeof *run->trail->past);
}

/* Order and step of the next sub-step: the order with the least error, a lower one only for a quarter of it, since an
 * exchange of rows disturbs the next estimates; and twice the step where that keeps the error below half the tolerance.
 * Both are left alone until the corrections come from as many even steps as the order needs; at a start there are as many
 * slopes as the order wants at once. After Shampine and Gordon (1975), Computer Solution of Ordinary Differential
 * Equations, ch. 7. */
static inline void iso_adams_adapt(iso_adams_run *const run, real estimate, const iso_adams_neighbours neighbours)
{
    iso_adams_state *const state = run->state;
    state->age = (uint8_t)(state->age + (state->age < UINT8_MAX));
    state->overdue = state->overdue && estimate > R(1.0);
    if (!state->starting && state->age <= state->order) {
        return;
    }
    uint8_t order = state->order; /* of the estimate */
    if (state->starting) {
        iso_adams_raise(run);
        state->starting = state->order < ISO_ADAMS_ORDERS;
    } else if (R(4.0) * neighbours.lower < estimate) {
        iso_adams_lower(run);
        estimate = neighbours.lower;
        order--;
    } else if (neighbours.higher < estimate) {
        iso_adams_raise(run);
        estimate = neighbours.higher;
        order++;
    }
    const real growth = (real)(4 << order); /* 2^(order + 1), and the half */
    if (growth * estimate <= R(1.0) && state->level > 0 && run->remaining % 2 == 0) {
        iso_adams_double(run);
    }
}

/* What becomes of a sub-step with too large an error: true if it has to be tried again. Halving divides the estimate by
 * 2^(order + 1), at least by 4, where the motion is smooth, and by 2 where the slope jumped: more than a third of the
 * one before, estimated at twice the step, tells a jump. */
static inline bool iso_adams_reject(iso_adams_run *const run, const real estimate, const real before)
{
    iso_adams_state *const state = run->state;
    const bool fresh = state->starting && state->order == 1;
    const bool jump = before > R(0.0) && estimate > before / R(3.0) && !fresh;
    if (jump && run->remaining <= run->left) {
        state->restarts++;
        iso_adams_begin(run);
    } else if (iso_adams_can_halve(run)) {
        state->starting = fresh;
        iso_adams_halve(run);
    } else {
        state->budget_bound++;
        state->overdue = true;
        return false;
    }
    state->rejected++;
    return true;
}

/* Walks to the end of the tick, or until the states are not finite. */
static inline void iso_adams_walk(iso_adams_run *const run)
{
    real before = R(0.0);
    while (run->remaining > 0) {
        if (run->state->overdue && iso_adams_can_halve(run)) {
            iso_adams_halve(run);
        }
        run->left--;
        const real estimate = iso_adams_try(run);
        if (estimate > R(1.0) && iso_adams_reject(run, estimate, before)) {
            before = estimate;
        } else {
            before = R(0.0);
            run->remaining = iso_not_finite(estimate) == 0 ? run->remaining - 1 : 0;
            run->state->substeps++;
            iso_adams_adapt(run, estimate, iso_adams_correct(run));
        }
    }
}

static inline iso_adams_run iso_adams_run_of(const iso_adams_options *const options, iso_adams_state *const state,
                                             const iso_trail *const trail, iso_derivative *const f, const real h_tick,
                                             const real *const u, const real *const p, real *const work)
{
    const size_t n = trail->n;
    return (iso_adams_run){
        .options = options,
        .state = state,
        .trail = trail,
        .f = f,
        .u = u,
        .p = p,
        .h_tick = h_tick,
        .remaining = (uint32_t)1 << state->level,
        .left = options->budget,
        .slope = work,
        .at = work + n,
        .increment = work + 2 * n,
        .error = work + 3 * n,
    };
}

/* Before the first tick, and after a jump: starts from the states in the trail, whose past is [ISO_ADAMS_ROWS n]. One
 * evaluation. The counts go on. work[ISO_ADAMS_WORK(n)]. */
static inline void iso_adams_start(const iso_adams_options *const options, iso_adams_state *const state,
                                   const iso_trail *const trail, iso_derivative *const f, const real h_tick,
                                   const real *const u, const real *const p, real *const work)
{
    state->level = 0;
    state->overdue = false;
    iso_adams_run run = iso_adams_run_of(options, state, trail, f, h_tick, u, p, work);
    iso_adams_begin(&run);
}

/* Advances the states by one tick with u and p held. work[ISO_ADAMS_WORK(n)]. Returns the largest part of its local
 * error, absolute: the estimates of its sub-steps, added up state by state. */
static inline real iso_adams_tick(const iso_adams_options *const options, iso_adams_state *const state,
                                  const iso_trail *const trail, iso_derivative *const f, const real h_tick,
                                  const real *const u, const real *const p, real *const work)
{
    iso_adams_run run = iso_adams_run_of(options, state, trail, f, h_tick, u, p, work);
    real largest = R(0.0);
    memset(run.error, 0, trail->n * sizeof *run.error);
    while (run.remaining > run.left) {
        iso_adams_double(&run);
    }
    if (options->driven) {
        iso_adams_take_slope(&run);
    }
    iso_adams_walk(&run);
    for (size_t s = 0; s < trail->n; s++) {
        largest = iso_larger(largest, run.error[s]);
    }
    return largest;
}

#endif
