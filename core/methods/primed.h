/* The history of a method before its first step: where ISO_IS_PRIMED(recipe). */
#ifndef ISO_CORE_METHODS_PRIMED_H
#define ISO_CORE_METHODS_PRIMED_H

#include "core/methods/method.h"
#include "core/methods/prime.h"

/* Computes the history behind the states of x, before the first step or after a discontinuity; the states do not
 * change. lu[eq->factors] only for implicit methods, work[ISO_METHOD_PRIME_WORK(recipe, n)], progress as of a step. */
ISO_INLINE void iso_method_prime(const unsigned recipe, const size_t n, const iso_equations *const eq, const real h,
                                 real *const x, const real *const u, const real *const p, real *const lu,
                                 real *const work, iso_progress *const progress)
{
    const iso_history history = iso_history_of(recipe, n, x);
    iso_step step = iso_step_of(recipe, &history, eq, h, u, p, lu, work, progress);
    if (ISO_IS_PRIMED(recipe)) {
        switch (ISO_METHOD_OF(recipe)) {
#define ISO_PRIME_CASE(r, m, name)                                                                                     \
    case m:                                                                                                            \
        m##_PRIMES(r)(&step);                                                                                          \
        break;
            ISO_METHOD_LIST(ISO_PRIME_CASE, recipe)
        default:
            break;
        }
    }
}

#endif
