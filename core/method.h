/* The methods behind one name: a plant says which, and the others leave no trace in its code.
 *
 * `method` and n are constants where a plant calls these functions, so that the dispatch is gone when they are
 * inlined. A plant keeps what its method must remember behind its state: x[ISO_METHOD_STATE(method, n)].
 */
#ifndef ISO_CORE_METHOD_H
#define ISO_CORE_METHOD_H

#include "core/explicit.h"
#include "core/multistep.h"

typedef enum iso_method { ISO_EULER, ISO_HEUN, ISO_RK4, ISO_AB4 } iso_method;

/* Picks the entry of a method; a constant expression if the method is one. */
#define ISO_METHOD_PICK(method, euler, heun, rk4, ab4)                                                                 \
    ((method) == ISO_EULER ? (euler) : (method) == ISO_HEUN ? (heun) : (method) == ISO_RK4 ? (rk4) : (ab4))

#define ISO_METHOD_NAME(method) ISO_METHOD_PICK(method, "euler", "heun", "rk4", "ab4")

/* Reals of x: the n states, and behind them the method's history. */
#define ISO_METHOD_STATE(method, n) ((n) + ISO_METHOD_PICK(method, 0, 0, 0, ISO_AB4_HISTORY(n)))

/* Reals of work space of a step: the slopes of all stages and the state of one; and of priming. */
#define ISO_METHOD_WORK(method, n) (ISO_METHOD_PICK(method, 2, 3, 5, 1) * (n))
#define ISO_METHOD_PRIME_WORK(method, n) ISO_METHOD_PICK(method, 1, 1, 1, (n) + ISO_EXPLICIT_WORK(n))

/* Advances the n states of x[ISO_METHOD_STATE(method, n)] by h with u and p held. work[ISO_METHOD_WORK(method, n)]. */
static inline void iso_method_step(const iso_method method, const size_t n, iso_derivative *const f, const real h,
                                   real *const x, const real *const u, const real *const p, real *const work)
{
    if (method == ISO_AB4) {
        iso_ab4_step(n, f, h, x, u, p, x + n, work);
    } else {
        const iso_tableau *const table =
            ISO_METHOD_PICK(method, &iso_tableau_euler, &iso_tableau_heun, &iso_tableau_rk4, NULL);
        iso_explicit_step(table, n, f, h, x, u, p, work);
    }
}

/* Fills the history behind the states of x, before the first step. work[ISO_METHOD_PRIME_WORK(method, n)]. */
static inline void iso_method_prime(const iso_method method, const size_t n, iso_derivative *const f, const real h,
                                    real *const x, const real *const u, const real *const p, real *const work)
{
    if (method == ISO_AB4) {
        iso_ab4_prime(n, f, h, x, u, p, x + n, work, work + n);
    }
}

#endif
