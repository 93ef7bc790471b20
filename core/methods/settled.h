/* The local error of steps whose states a plant corrects: for a recipe with ISO_SETTLED. */
#ifndef ISO_CORE_METHODS_SETTLED_H
#define ISO_CORE_METHODS_SETTLED_H

#include "core/methods/method.h"

/* Where a plant corrects its states after a step, to constraints or to unit length, the local error is that of the
 * corrected states. These two functions stand before and after the correction, for a recipe with ISO_SETTLED; eq, x and
 * work are those of the step. To the first order the correction is the part of the error that it removes. */
ISO_INLINE void iso_method_settles(const unsigned recipe, const size_t n, const iso_equations *const eq,
                                   const real *const x, real *const work)
{
    memcpy(iso_method_room(recipe, eq, work) + ISO_METHOD_ERRORS(recipe, n) + n, x, n * sizeof *x);
}

ISO_INLINE void iso_method_settled(const unsigned recipe, const size_t n, const iso_equations *const eq, real *const x,
                                   real *const work, iso_progress *const progress)
{
    const iso_history history = iso_history_of(recipe, n, x);
    const real *const errors = iso_method_room(recipe, eq, work) + ISO_METHOD_ERRORS(recipe, n);
    const real *const before = errors + n;
    const bool by_derivatives = ISO_CHECKS_DERIVATIVES(recipe);
    const bool kept = ISO_KEEPS_ERROR(recipe);
    real *const kept_error = history.check - n; /* the last vector of the past */
    real largest = R(0.0);
    ISO_UNROLL
    for (size_t s = 0; s < n; s++) {
        const real moved = x[s] - before[s];
        if (by_derivatives) {
            iso_check_moved(&history, s, moved);
        } else if (kept) {
            kept_error[s] += moved;
        } else {
            largest = iso_larger(largest, errors[s] + moved);
        }
    }
    if (!by_derivatives && !kept) {
        progress->local_error = largest;
    }
}

#endif
