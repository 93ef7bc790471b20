/* Two rates in one step: the fast states of a plant take sub-steps, all others one step of the same explicit method.
 *
 * A stage of the slow states at c h asks for the fast ones there. These go there in sub-steps of the same method, while
 * the slow states move along the parabola that begins with their slope k_0 and ends at the stage:
 *
 *     x(t) = x + t (a + t b), t = 0 .. c,    a = h k_0,    x(c) = the state of the stage
 *
 * So the fast states of a stage belong to its slow ones, however fast they are: where they settle within a sub-step,
 * the result is the method itself with the settled values. Stages at one place are made one after the other from one
 * place; the next goes on from their mean. The errors of their paths have opposite signs in rk4, as those of the stages
 * themselves.
 *
 * The last stage takes the fast states that make the weighted mean of all stages that of the sub-steps:
 *
 *     sum_i b_i z_i = h^-1 integral of z dt
 *
 * The slow states thus feel the mean of the fast ones over a step, such as the torque of a current, and not their
 * values at a few points. With one stage only, the fast states go first, with the slow ones held, and that stage takes
 * their mean.
 *
 * Orders 1, 2 and 3 with euler, heun and rk4; 2 with others of a higher order. Stages that are parts of one flow:
 * Knoth, Wolke (1998), Implicit-explicit Runge-Kutta methods for computing atmospheric reactive flows, Appl. Numer.
 * Math. 28, 327-341; Sandu (2019), A class of multirate infinitesimal GARK methods, SIAM J. Numer. Anal. 57, 2300-2327.
 */
#ifndef ISO_CORE_METHODS_MULTIRATE_H
#define ISO_CORE_METHODS_MULTIRATE_H

#include "core/methods/method.h"

/* The fast states, and the states that their derivative reads. */
typedef struct iso_fast {
    iso_derivative *derivative; /* dx[count], of the fast states alone, in their order */
    const uint16_t *states;     /* [count] their places among the states, which rise */
    size_t count;
    const bool *is_fast;   /* [n] which states these are */
    const uint16_t *reads; /* [read_count] the slow states that the derivative reads */
    size_t read_count;
    int substeps; /* in a step: one ends at each stage of the slow states but the last */
} iso_fast;

/* Reals of work space, with n states, `count` fast ones, and so many slow ones that these read. */
enum { ISO_MULTIRATE_VECTORS = 7 };
#define ISO_MULTIRATE_WORK(recipe, n, count, read_count)                                                               \
    ((size_t)(ISO_EVALUATIONS_OF(recipe) + 2) * (n) +                                                                  \
     (size_t)(ISO_EVALUATIONS_OF(recipe) + ISO_MULTIRATE_VECTORS) * (count) + 2 * (size_t)(read_count))

/* A step in progress. The vectors are in the work space. */
typedef struct iso_multirate {
    const iso_tableau *table;
    const iso_step *step;
    const iso_fast *fast;
    real *k;         /* [stages n] the derivatives at the stages */
    real *at;        /* [n] a stage */
    real *within;    /* [n] a stage of a sub-step */
    real *inner;     /* [stages count] its derivatives */
    real *begin;     /* [count] the fast states from which the stages of one place go on */
    real *begin_sum; /* [count] the sum of their values in the sub-steps until there, times b_over */
    real *end;       /* [count] each: both where a stage ends */
    real *end_sum;
    real *ends; /* [count] each: both, summed over the stages of one place */
    real *ends_sum;
    real *slow_sum; /* the values that the slow states took of them so far, times b_i */
    real *slope;    /* [read_count] a and b of a parabola */
    real *bend;
} iso_multirate;

ISO_INLINE iso_multirate iso_multirate_of(const iso_tableau *const table, const iso_step *const step,
                                          const iso_fast *const fast)
{
    const size_t n = step->history->n, count = fast->count;
    iso_multirate result = {.table = table, .step = step, .fast = fast, .k = step->work};
    result.at = result.k + table->stages * n;
    result.within = result.at + n;
    result.inner = result.within + n;
    result.begin = result.inner + table->stages * count;
    result.begin_sum = result.begin + count;
    result.end = result.begin_sum + count;
    result.end_sum = result.end + count;
    result.ends = result.end_sum + count;
    result.ends_sum = result.ends + count;
    result.slow_sum = result.ends_sum + count;
    result.slope = result.slow_sum + count;
    result.bend = result.slope + fast->read_count;
    return result;
}

/* The slow states that the derivative reads, so many sub-steps after the start. */
ISO_INLINE void iso_multirate_follow(const iso_multirate *const m, const real substeps)
{
    const real part = substeps * (R(1.0) / iso_whole(m->fast->substeps));
    ISO_UNROLL
    for (size_t r = 0; r < m->fast->read_count; r++) {
        const size_t s = m->fast->reads[r];
        m->within[s] = m->step->history->x[s] + part * (m->slope[r] + part * m->bend[r]);
    }
}

/* A stage of a sub-step: the fast states there, with their part of the mean, and their derivatives. Where it begins,
 * the slow states stand from the end of the one before, if a stage was there. */
ISO_INLINE void iso_multirate_inner_stage(const iso_multirate *const m, const int number, const uint8_t i)
{
    const iso_tableau *const table = m->table;
    const iso_fast *const fast = m->fast;
    const real h_over = m->step->h / iso_whole(fast->substeps) / iso_whole(table->a_over[i]);
    const uint8_t last = (uint8_t)(table->stages - 1);
    const bool stand =
        i > 0 ? iso_stage_is_at(table, i, 1) : last == 0 || iso_stage_sum(table, last) == table->a_over[last];
    if (!stand) {
        iso_multirate_follow(m, iso_whole(number) + iso_stage_at(table, i));
    }
    ISO_UNROLL
    for (size_t s = 0; s < fast->count; s++) {
        const real *const k = m->inner + s;
        const real z = i == 0 ? m->end[s] : m->end[s] + iso_combine(h_over, table->a[i], i, k, fast->count);
        m->within[fast->states[s]] = z;
        m->end_sum[s] += iso_whole(table->b[i]) * z;
    }
    fast->derivative(m->inner + i * fast->count, m->within, m->step->u, m->step->p);
}

/* The fast states from `begin` to `end`, through these sub-steps. The mean is an integral by the same method. */
ISO_INLINE void iso_multirate_pass(const iso_multirate *const m, const int from, const int to)
{
    const iso_tableau *const table = m->table;
    const size_t count = m->fast->count;
    const real h_over = m->step->h / iso_whole(m->fast->substeps) / iso_whole(table->b_over);
    ISO_UNROLL
    for (size_t s = 0; s < count; s++) {
        m->end[s] = m->begin[s];
        m->end_sum[s] = m->begin_sum[s];
    }
    iso_multirate_follow(m, iso_whole(from));
    for (int number = from; number < to; number++) {
        ISO_UNROLL
        for (uint8_t i = 0; i < table->stages; i++) {
            iso_multirate_inner_stage(m, number, i);
        }
        ISO_UNROLL
        for (size_t s = 0; s < count; s++) {
            m->end[s] += iso_combine(h_over, table->b, table->stages, m->inner + s, count);
        }
    }
}

/* The state of a stage, and the parabola that leads to it. That of the first after the start is straight. */
ISO_INLINE void iso_multirate_aim(const iso_multirate *const m, const uint8_t i)
{
    const size_t n = m->step->history->n;
    const real *const x = m->step->history->x, h = m->step->h;
    const real c = iso_stage_at(m->table, i);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        m->at[s] =
            i == 0 ? x[s] : x[s] + iso_combine(h / iso_whole(m->table->a_over[i]), m->table->a[i], i, m->k + s, n);
    }
    ISO_UNROLL
    for (size_t r = 0; r < m->fast->read_count; r++) {
        const size_t s = m->fast->reads[r];
        m->slope[r] = i == 0 ? R(0.0) : h * m->k[s];
        m->bend[r] = i < 2 ? R(0.0) : (m->at[s] - x[s] - c * m->slope[r]) * (R(1.0) / (c * c));
    }
}

/* The stages of one place are done: the next begins at their mean. */
ISO_INLINE void iso_multirate_go_on(const iso_multirate *const m, const int stages)
{
    const real part = R(1.0) / iso_whole(stages);
    ISO_UNROLL
    for (size_t s = 0; s < m->fast->count; s++) {
        m->begin[s] = part * m->ends[s];
        m->begin_sum[s] = part * m->ends_sum[s];
        m->ends[s] = m->ends_sum[s] = R(0.0);
    }
}

/* Puts into a stage the values of the fast states for the slow ones. */
ISO_INLINE void iso_multirate_give(const iso_multirate *const m, const uint8_t i)
{
    const iso_tableau *const table = m->table;
    ISO_UNROLL
    for (size_t s = 0; s < m->fast->count; s++) {
        real z = m->end[s];
        m->ends[s] += z;
        m->ends_sum[s] += m->end_sum[s];
        if (i + 1 == table->stages) {
            const real mean = m->end_sum[s] * (R(1.0) / iso_whole(m->fast->substeps));
            z = (mean - m->slow_sum[s]) * (R(1.0) / iso_whole(table->b[i]));
        }
        m->slow_sum[s] += iso_whole(table->b[i]) * z;
        m->at[m->fast->states[s]] = z;
    }
}

/* The sub-step at which a stage is; that of the last is the end of the step. */
ISO_INLINE int iso_multirate_place(const iso_multirate *const m, const uint8_t i)
{
    const int substeps = m->fast->substeps;
    return i + 1 == m->table->stages ? substeps : iso_stage_sum(m->table, i) * substeps / m->table->a_over[i];
}

/* All stages after the start. */
ISO_INLINE void iso_multirate_stages(const iso_multirate *const m)
{
    const iso_tableau *const table = m->table;
    const size_t n = m->step->history->n;
    int from = 0, to = 0, stages = 0;
    ISO_UNROLL
    for (uint8_t i = table->stages > 1; i < table->stages; i++) {
        const int place = iso_multirate_place(m, i);
        if (stages > 0 && place != to) {
            iso_multirate_go_on(m, stages);
            from = to;
            stages = 0;
        }
        to = place;
        stages++;
        iso_multirate_aim(m, i);
        iso_multirate_pass(m, from, to);
        iso_multirate_give(m, i);
        iso_evaluate(m->step, m->k + i * n, m->at);
    }
}

/* Advances the n states of x[ISO_METHOD_STATE(recipe, n)] by h, as iso_method_step does, the fast ones in sub-steps.
 * work[ISO_MULTIRATE_WORK(recipe, n, fast->count, fast->read_count)]. Inputs are held, and no error is estimated. */
ISO_INLINE void iso_multirate_step(const unsigned recipe, const size_t n, const iso_equations *const eq,
                                   const iso_fast *const fast, const real h, real *const x, const real *const u,
                                   const real *const p, real *const work)
{
    const iso_history history = iso_history_of(recipe, n, x);
    const iso_step step = iso_step_of(recipe, &history, eq, h, u, p, NULL, work, NULL);
    const iso_tableau *const table = iso_tableau_of(recipe);
    const iso_multirate m = iso_multirate_of(table, &step, fast);
    if (table->stages > 1) {
        iso_evaluate(&step, m.k, x);
    }
    ISO_UNROLL
    for (size_t s = 0; s < fast->count; s++) {
        m.begin[s] = x[fast->states[s]];
        m.slow_sum[s] = table->stages > 1 ? iso_whole(table->b[0]) * m.begin[s] : R(0.0);
        m.begin_sum[s] = m.ends[s] = m.ends_sum[s] = R(0.0);
    }
    iso_multirate_stages(&m);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        if (!fast->is_fast[s]) {
            iso_advance(&history, s, iso_combine(h / iso_whole(table->b_over), table->b, table->stages, m.k + s, n));
        }
    }
    ISO_UNROLL
    for (size_t s = 0; s < fast->count; s++) {
        iso_advance(&history, fast->states[s], m.end[s] - x[fast->states[s]]);
    }
}

#endif
