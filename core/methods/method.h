/* The methods behind one name: a plant chooses one, and the others add nothing to its code.
 *
 * Recipe and n are constants where a plant calls these functions, so that inlining removes the dispatch. The history of
 * a method is behind the state: x[ISO_METHOD_STATE(recipe, n)].
 */
#ifndef ISO_CORE_METHODS_METHOD_H
#define ISO_CORE_METHODS_METHOD_H

#include "core/methods/table.h"

/* The degree in a function: every use of the macro is all rows of the table three times, which a checker is slow to
 * read. */
ISO_INLINE uint8_t iso_degree_of(const unsigned recipe)
{
    return (uint8_t)ISO_DEGREE(recipe);
}

static inline iso_history iso_history_of(const unsigned recipe, const size_t n, real *const x)
{
    const uint8_t checked = (uint8_t)ISO_CHECK_KEPT(recipe);
    iso_history history = {.n = n, .x = x, .past = x + n, .checked = checked, .centred = ISO_IS_CENTRED(recipe)};
    history.check = history.past + n * (size_t)ISO_PAST_KEPT(recipe);
    if (ISO_IS_COMPENSATED(recipe)) {
        history.compensation = history.check + n * checked;
    }
    return history;
}

/* The work space of the method, behind the room for sines and for inputs. */
ISO_INLINE real *iso_method_room(const unsigned recipe, const iso_equations *const eq, real *const work)
{
    real *const behind_sines = work + ISO_METHOD_SINES(recipe, eq->angle_count, eq->kept);
    return iso_degree_of(recipe) > 0 ? behind_sines + eq->held : behind_sines;
}

/* The first evaluation of a step. The sines that stages take theirs from stand in the memory where it was prepared,
 * else they are found. */
ISO_INLINE void iso_evaluate_start(const unsigned recipe, iso_step *const step, real *const work)
{
    const iso_equations *const eq = step->equations;
    real *const x = step->history->x;
    const bool by_sines = ISO_BY_SINES(recipe) && eq->angle_count > 0;
    step->sines = NULL;
    if (by_sines) {
        step->sines = ISO_IS_PREPARED(recipe) ? x + ISO_METHOD_STATE(recipe, step->history->n) : work;
        step->sines_here = work + 2 * eq->angle_count;
    }
    if (ISO_IS_PREPARED(recipe)) {
        eq->prepared(step->work, x, step->u, step->p);
    } else if (by_sines) {
        iso_find_sines(eq->angles, eq->angle_count, x, work);
        step->by_sines(step->work, x, step->u, step->p, work, NULL);
    } else {
        iso_evaluate(step, step->work, x);
    }
}

/* A step or its priming, as a kernel takes it. */
ISO_INLINE iso_step iso_step_of(const unsigned recipe, const iso_history *const history, const iso_equations *const eq,
                                const real h, const real *const u, const real *const p, real *const lu,
                                real *const work, iso_progress *const progress)
{
    return (iso_step){.history = history,
                      .equations = eq,
                      .f = eq->derivative,
                      .by_sines = eq->by_sines,
                      .h = h,
                      .u = u,
                      .p = p,
                      .lu = lu,
                      .work = iso_method_room(recipe, eq, work),
                      .iterations = (uint8_t)ISO_ITERATIONS_OF(recipe),
                      .progress = progress,
                      .degree = iso_degree_of(recipe),
                      .checked = ISO_IS_CHECKED(recipe)};
}

/* Before a step: takes the samples of its inputs, which are behind u: ISO_METHOD_SAMPLES(recipe, inputs). */
ISO_INLINE void iso_method_sample(const unsigned recipe, const iso_equations *const eq, real *const u)
{
    if (iso_degree_of(recipe) > 0) {
        iso_take_samples(eq, iso_degree_of(recipe), u);
    }
}

/* After a discontinuity, before iso_method_prime: forgets the samples. */
ISO_INLINE void iso_method_forget(const unsigned recipe, const iso_equations *const eq, real *const u)
{
    if (iso_degree_of(recipe) > 0) {
        iso_forget_samples(eq, iso_degree_of(recipe), u);
    }
}

/* Advances the n states of x[ISO_METHOD_STATE(recipe, n)] by h with p held, and u but for smooth inputs.
 * lu[eq->factors] only for implicit methods, work[ISO_METHOD_WORK(recipe, n)]; progress where ISO_HAS_PROGRESS(recipe),
 * of adams an iso_adams_state. */
ISO_INLINE void iso_method_step(const unsigned recipe, const size_t n, const iso_equations *const eq, const real h,
                                real *const x, const real *const u, const real *const p, real *const lu,
                                real *const work, iso_progress *const progress)
{
    const iso_history history = iso_history_of(recipe, n, x);
    iso_step step = iso_step_of(recipe, &history, eq, h, u, p, lu, work, progress);
    step.errors = ISO_IS_SETTLED(recipe) ? step.work + ISO_METHOD_ERRORS(recipe, n) : NULL;
    switch (ISO_METHOD_OF(recipe)) {
#define ISO_STEP_CASE(r, m, name)                                                                                      \
    case m:                                                                                                            \
        if (m##_KIND(r) == ISO_FROM_START && m##_SOLUTIONS(r) == 0) {                                                  \
            iso_evaluate_start(recipe, &step, work);                                                                   \
        }                                                                                                              \
        iso_##name##_step(&step);                                                                                      \
        break;
        ISO_METHOD_LIST(ISO_STEP_CASE, recipe)
    default:
        break;
    }
    if (ISO_IS_CHECKED(recipe) || ISO_IS_VARYING(recipe)) {
        progress->local_error = step.error;
    }
    if (ISO_IS_WATCHED(recipe)) {
        iso_watch(progress, step.error);
    }
}

/* After a step by sines of a plant that keeps values of it: the sines and cosines at its end, and these values behind
 * them. work is that of the step. */
ISO_INLINE const real *iso_method_end_sines(const iso_equations *const eq, const real *const work)
{
    return work + 2 * eq->angle_count;
}

/* x[at[i]] += moved[i], i < count: the corrections of a plant's states after a step, with the compensation of the sums
 * of the step. */
ISO_INLINE void iso_method_move(const unsigned recipe, const size_t n, real *const x, const uint16_t *const at,
                                const real *const moved, const size_t count)
{
    const iso_history history = iso_history_of(recipe, n, x);
    ISO_UNROLL
    for (size_t i = 0; i < count; i++) {
        iso_add(&history, at[i], moved[i]);
    }
}

#endif
