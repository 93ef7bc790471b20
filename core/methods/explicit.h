/* Explicit one-step methods: one loop over a Butcher table.
 *
 * With the table and n known at compile time the loops unroll and the table turns into constants; no branch, index or
 * loop count depends on x, u or p. Called with n known only at run time it gives the same bits.
 */
#ifndef ISO_CORE_METHODS_EXPLICIT_H
#define ISO_CORE_METHODS_EXPLICIT_H

#include "core/methods/step.h"

enum { ISO_STAGES_MAX = 8 };

/* Vectors of work space for the most stages: the derivatives of all, and the state of one. */
enum { ISO_EXPLICIT_VECTORS = ISO_STAGES_MAX + 1 };

/* Row i is a[i][j] / a_over[i], the weights are b[j] / b_over. Whole numbers keep the order conditions exact (a test
 * proves them in integers) and keep the weights from adding up to something other than one in float. */
typedef struct iso_tableau {
    uint8_t stages;
    uint8_t order;
    int8_t a[ISO_STAGES_MAX][ISO_STAGES_MAX]; /* strictly lower triangular */
    int8_t a_over[ISO_STAGES_MAX];
    int8_t b[ISO_STAGES_MAX];
    int8_t b_over;
} iso_tableau;

/* h / over * (c[0] k[0] + c[1] k[n] + ...) over the terms with c != 0; neighbours with the same c are added first. At
 * least one c is not zero. */
static inline real iso_combine(const real h_over, const int8_t *const c, const uint8_t terms, const real *const k,
                               const size_t n)
{
    real sum = R(0.0), same = R(0.0);
    bool first = true;
    ISO_UNROLL
    for (uint8_t j = 0; j < terms; j++) {
        const bool ends = j + 1 == terms || c[j + 1] != c[j];
        same = j > 0 && c[j - 1] == c[j] ? same + k[j * n] : k[j * n];
        if (c[j] != 0 && ends) {
            const real term = iso_whole(c[j]) * same;
            sum = first ? term : sum + term;
            first = false;
        }
    }
    return h_over * sum;
}

/* a_over[i] times c_i = sum_j a_ij, the part of the step at which stage i is; iso_stage_at is c_i. */
ISO_INLINE int iso_stage_sum(const iso_tableau *const table, const uint8_t i)
{
    int sum = 0;
    ISO_UNROLL
    for (uint8_t j = 0; j < i; j++) {
        sum += table->a[i][j];
    }
    return sum;
}

ISO_INLINE real iso_stage_at(const iso_tableau *const table, const uint8_t i)
{
    return iso_whole(iso_stage_sum(table, i)) / iso_whole(table->a_over[i]);
}

/* Whether stage i is at so many times the part of the stage before; i > 0. */
ISO_INLINE bool iso_stage_is_at(const iso_tableau *const table, const uint8_t i, const int times)
{
    return iso_stage_sum(table, i) * table->a_over[i - 1] == times * iso_stage_sum(table, i - 1) * table->a_over[i];
}

/* How far stage i is from the start, in the state whose derivatives are k[], k[n], ... */
ISO_INLINE real iso_stage_move(const iso_tableau *const table, const iso_step *const step, const uint8_t i,
                               const real *const k)
{
    return iso_combine(step->h / iso_whole(table->a_over[i]), table->a[i], i, k, step->history->n);
}

/* Twice an angle of which this is sine and cosine, less another one: the direction of that, mirrored at the first. */
static inline iso_sine_cosine iso_sincos_mirrored(const iso_sine_cosine middle, const iso_sine_cosine from)
{
    const real twice = R(2.0) * (middle.sin * from.sin + middle.cos * from.cos);
    return (iso_sine_cosine){twice * middle.sin - from.sin, twice * middle.cos - from.cos};
}

/* Sine and cosine of an angle that may turn far in a step, at stage i, which is `move` beyond the start, at another
 * time than the stage before. At twice the time of that it is near the mirrored angle: that of a turn at constant
 * speed. Else they are those of the angle itself. */
ISO_INLINE iso_sine_cosine iso_spun_sines(const iso_tableau *const table, const iso_step *const step, const uint8_t i,
                                          const size_t a, const real move)
{
    const size_t s = iso_angle(step->equations->angles, a);
    if (i > 1 && iso_stage_is_at(table, i, 2)) {
        const iso_sine_cosine from = {step->sines[2 * a], step->sines[2 * a + 1]};
        const iso_sine_cosine middle = {step->sines_here[2 * a], step->sines_here[2 * a + 1]};
        return iso_sincos_close(iso_sincos_mirrored(middle, from),
                                move - R(2.0) * iso_stage_move(table, step, i - 1, step->work + s));
    }
    return iso_sincos(step->history->x[s] + move);
}

/* Sine and cosine of the angles of a stage, each from the difference of its angle to that at the start, by the
 * combination of the derivatives; or to that of the stage before, where both are at the same time. These series lose
 * less than the method does: their error is of the seventh order at least, in float of the sixth between two stages,
 * and with a weight below 1e-4 and 1e-2. */
ISO_INLINE void iso_stage_sines(const iso_tableau *const table, const iso_step *const step, const uint8_t i)
{
    const iso_equations *const eq = step->equations;
    const bool is_close = i > 1 && iso_stage_is_at(table, i, 1);
    const real *const from = is_close ? step->sines_here : step->sines;
    ISO_UNROLL
    for (size_t a = 0; a < eq->angle_count; a++) {
        const real *const k = step->work + iso_angle(eq->angles, a);
        const iso_sine_cosine near = {from[2 * a], from[2 * a + 1]};
        const real move = iso_stage_move(table, step, i, k);
        const bool spins = eq->spins != NULL && eq->spins[a];
        const iso_sine_cosine here = is_close ? iso_sincos_close(near, move - iso_stage_move(table, step, i - 1, k))
                                     : spins  ? iso_spun_sines(table, step, i, a, move)
                                              : iso_sincos_beyond(near, move);
        step->sines_here[2 * a] = here.sin;
        step->sines_here[2 * a + 1] = here.cos;
    }
}

/* The place of the values that the last stage keeps: behind its sines. */
ISO_INLINE real *iso_kept_place(const iso_step *const step)
{
    return step->sines_here + 2 * step->equations->angle_count;
}

/* Turns the sines of the last stage into those of the end, for the computations after a step; moves[] of the states are
 * from the start. The last stage is at the same time. */
ISO_INLINE void iso_end_sines(const iso_tableau *const table, const iso_step *const step, const real *const moves)
{
    const iso_equations *const eq = step->equations;
    ISO_UNROLL
    for (size_t a = 0; a < eq->angle_count; a++) {
        const size_t s = iso_angle(eq->angles, a);
        const iso_sine_cosine near = {step->sines_here[2 * a], step->sines_here[2 * a + 1]};
        const real last = iso_stage_move(table, step, table->stages - 1, step->work + s);
        const iso_sine_cosine end = iso_sincos_close(near, moves[s] - last);
        step->sines_here[2 * a] = end.sin;
        step->sines_here[2 * a + 1] = end.cos;
    }
}

/* k_i = f(t + c_i h, x + h sum_j a_ij k_j), x += h sum_i b_i k_i, from k_0 = f(x) on. work[(stages + 1) n], without the
 * last for one stage. Local error of order h^(order + 1). Butcher (2016), Numerical Methods for Ordinary Differential
 * Equations, eqs. 221a-d. The weights add up to one, so that a steady derivative needs the first stage alone. By sines,
 * where step->sines are those of the start. */
ISO_INLINE void iso_explicit_step_by(const iso_tableau *const table, iso_step *const step, const bool by_sines)
{
    const iso_history *const history = step->history;
    const size_t n = history->n;
    real *const k = step->work;
    real *const at = step->work + table->stages * n;
    const bool keeps = by_sines && step->equations->kept > 0;

    ISO_UNROLL
    for (uint8_t i = 1; i < table->stages; i++) {
        const real h_over = step->h / iso_whole(table->a_over[i]);
        ISO_UNROLL
        for (size_t s = by_sines ? step->equations->unread : 0; s < n; s++) {
            at[s] = history->x[s] + iso_combine(h_over, table->a[i], i, k + s, n);
        }
        if (by_sines) {
            iso_stage_sines(table, step, i);
            real *const kept = keeps && i + 1 == table->stages ? iso_kept_place(step) : NULL;
            step->by_sines(k + i * n, at, iso_inputs_at(step, iso_stage_at(table, i)), step->p, step->sines_here, kept);
        } else {
            iso_evaluate_at(step, iso_stage_at(table, i), k + i * n, at);
        }
    }

    const real h_over = step->h / iso_whole(table->b_over);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const bool is_steady = step->equations->steady != NULL && step->equations->steady[s];
        const real move = is_steady ? step->h * k[s] : iso_combine(h_over, table->b, table->stages, k + s, n);
        if (keeps) {
            at[s] = move;
        }
        iso_advance(history, s, move);
    }
    if (keeps) {
        iso_end_sines(table, step, at);
    }
}

ISO_INLINE void iso_explicit_step(const iso_tableau *const table, iso_step *const step)
{
    iso_explicit_step_by(table, step, false);
}

/* A step of a method with this table, behind its first evaluation. */
ISO_INLINE void iso_explicit_method(const iso_tableau *const table, iso_step *const step)
{
    iso_step_begun(step);
    iso_explicit_step_by(table, step, step->sines != NULL);
}

#endif
