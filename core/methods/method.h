/* The methods behind one name: a plant says which, and the others leave no trace in its code.
 *
 * A recipe is a method with its options: ISO_RK4, or ISO_BDF4 | ISO_COMPENSATED | ISO_ITERATIONS(3). Recipe and n are
 * constants where a plant calls these functions, so that the dispatch is gone when they are inlined. What a method must
 * remember stands behind the state: x[ISO_METHOD_STATE(recipe, n)].
 */
#ifndef ISO_CORE_METHODS_METHOD_H
#define ISO_CORE_METHODS_METHOD_H

#include "core/methods/adams.h"
#include "core/methods/multistep.h"
#include "core/methods/progress.h"
#include "core/methods/stiff.h"

/* Every method, X(constant, name in a scene): those of a fixed step, which iso_method_step does, and last the one whose
 * step varies within the tick, which a plant calls itself. Semi-implicit Euler is of a mechanical plant: half of the
 * states are positions, half their rates. Abm4 evaluates after its correction too (PECE). */
#define ISO_METHOD_LIST(X)                                                                                             \
    X(ISO_EULER, "euler")                                                                                              \
    X(ISO_HEUN, "heun")                                                                                                \
    X(ISO_RK4, "rk4")                                                                                                  \
    X(ISO_AB4, "ab4")                                                                                                  \
    X(ISO_SEMI_IMPLICIT, "semi_implicit")                                                                              \
    X(ISO_ABM4, "abm4")                                                                                                \
    X(ISO_ABM4_PEC, "abm4_pec")                                                                                        \
    X(ISO_ABM4_PECECE, "abm4_pecece")                                                                                  \
    X(ISO_BDF4, "bdf4")                                                                                                \
    X(ISO_ROSENBROCK, "rosenbrock")                                                                                    \
    X(ISO_ADAMS, "adams")
#define ISO_METHOD_CONSTANT(constant, name) constant,
#define ISO_METHOD_ENTRY(constant, name) [constant] = (name),

typedef enum iso_method { ISO_METHOD_LIST(ISO_METHOD_CONSTANT) ISO_METHODS = ISO_ADAMS } iso_method;

/* What they are called: an array of ISO_METHODS + 1. */
#define ISO_METHOD_NAMES                                                                                               \
    {                                                                                                                  \
        ISO_METHOD_LIST(ISO_METHOD_ENTRY)                                                                              \
    }

/* Options, each of which costs nothing where it is not named. */
enum {
    ISO_METHOD_BITS = 0xF,
    ISO_COMPENSATED = 0x10, /* sums of increments without loss (Kahan-Babuska) */
    ISO_CHECKED = 0x20,     /* the local error of every step is known */
};

#define ISO_ITERATIONS(count) ((count) << 8) /* of Newton, for bdf4; 2 where nothing is said */

/* What a recipe is made of; constant expressions. */
#define ISO_METHOD_OF(recipe) ((recipe)&ISO_METHOD_BITS)
#define ISO_IS(recipe, method) (ISO_METHOD_OF(recipe) == (method))
#define ISO_IS_ABM4(recipe)                                                                                            \
    (ISO_IS(recipe, ISO_ABM4) || ISO_IS(recipe, ISO_ABM4_PEC) || ISO_IS(recipe, ISO_ABM4_PECECE))
#define ISO_IS_IMPLICIT(recipe) (ISO_IS(recipe, ISO_BDF4) || ISO_IS(recipe, ISO_ROSENBROCK))
#define ISO_ITERATIONS_OF(recipe) (((recipe) >> 8) == 0 ? 2 : ((recipe) >> 8))
#define ISO_IS_COMPENSATED(recipe) (((recipe)&ISO_COMPENSATED) != 0)
#define ISO_IS_CHECKED(recipe) (((recipe)&ISO_CHECKED) != 0)

/* In a plant that has no Jacobian: refuses the methods that need one when the plant is compiled. */
#define ISO_HAS_NO_JACOBIAN(recipe)                                                                                    \
    _Static_assert(!ISO_IS_IMPLICIT(recipe), "bdf4 and rosenbrock need a Jacobian, and this plant has none")

/* Whether a check compares with derivatives of the steps before; abm4 and bdf4 have an estimate of their own. */
#define ISO_CHECKS_DERIVATIVES(recipe)                                                                                 \
    (ISO_IS_CHECKED(recipe) && !ISO_IS_ABM4(recipe) && !ISO_IS(recipe, ISO_BDF4) && !ISO_IS(recipe, ISO_ADAMS))

/* Whether a jump of the motion is watched for: where steps are checked, and what is kept enters the next. */
#define ISO_IS_WATCHED(recipe)                                                                                         \
    (ISO_IS_CHECKED(recipe) && (ISO_IS_ABM4(recipe) || ISO_IS(recipe, ISO_AB4) || ISO_IS(recipe, ISO_BDF4)))

#define ISO_ORDER_OF(recipe)                                                                                           \
    (ISO_IS(recipe, ISO_EULER) || ISO_IS(recipe, ISO_SEMI_IMPLICIT)                                                    \
         ? 1                                                                                                           \
         : (ISO_IS(recipe, ISO_HEUN) ? 2 : (ISO_IS(recipe, ISO_ROSENBROCK) ? 3 : 4)))

/* Derivatives before the end of a step that its check uses: one more than the order. The leading term of an error can
 * pass through zero in all states at about the same time, and then the next one decides. */
#define ISO_CHECK_KEPT(recipe) (ISO_CHECKS_DERIVATIVES(recipe) ? ISO_ORDER_OF(recipe) + 1 : 0)

/* Vectors of n reals that are kept behind the state: sums or rows, increments, the check, what rounding has taken. */
#define ISO_PAST_KEPT(recipe)                                                                                          \
    (ISO_IS(recipe, ISO_ADAMS) ? ISO_ADAMS_ROWS                                                                        \
                               : (ISO_IS_ABM4(recipe) ? ISO_ABM4_SUMS : (ISO_IS(recipe, ISO_AB4) ? ISO_AB4_SUMS : 0)))
#define ISO_INCREMENTS_KEPT(recipe) (ISO_IS(recipe, ISO_BDF4) ? ISO_BDF4_STEPS : 0)
#define ISO_HISTORY_KEPT(recipe) (ISO_PAST_KEPT(recipe) + ISO_INCREMENTS_KEPT(recipe) + ISO_CHECK_KEPT(recipe))
#define ISO_VECTORS_KEPT(recipe) (ISO_HISTORY_KEPT(recipe) + (ISO_IS_COMPENSATED(recipe) ? 1 : 0))

/* Whether there is a history, which must be primed before the first step. */
#define ISO_IS_PRIMED(recipe) (ISO_HISTORY_KEPT(recipe) > 0)

/* Reals of x: the n states, and behind them what the method keeps. */
#define ISO_METHOD_STATE(recipe, n) ((n) * (1 + ISO_VECTORS_KEPT(recipe)))

/* Reals of work space of a step, beside the factors of an implicit method; and of priming. */
#define ISO_METHOD_WORK(recipe, n)                                                                                     \
    ((n) * (ISO_IS_IMPLICIT(recipe) || ISO_IS(recipe, ISO_RK4)                                                         \
                ? 5                                                                                                    \
                : (ISO_IS(recipe, ISO_HEUN) ? 3 : (ISO_IS(recipe, ISO_EULER) || ISO_IS_ABM4(recipe) ? 2 : 1))))
#define ISO_METHOD_PRIME_WORK(recipe, n)                                                                               \
    (ISO_IS(recipe, ISO_BDF4) ? ISO_BDF4_PRIME_WORK(n)                                                                 \
                              : (ISO_IS_IMPLICIT(recipe) ? (n) : (ISO_IS_PRIMED(recipe) ? ISO_PRIME_WORK(n) : 1)))

static inline iso_history iso_history_of(const unsigned recipe, const size_t n, real *const x)
{
    iso_history history = {.n = n, .x = x, .past = x + n, .checked = ISO_CHECK_KEPT(recipe)};
    history.increments = history.past + n * ISO_PAST_KEPT(recipe);
    history.check = history.increments + n * ISO_INCREMENTS_KEPT(recipe);
    if (ISO_IS_COMPENSATED(recipe)) {
        history.compensation = history.check + n * (size_t)ISO_CHECK_KEPT(recipe);
    }
    return history;
}

/* A local error so many times its usual size is a jump of the motion: kinks are by 1 / h or a higher power of it larger
 * than the error of a smooth motion, which grows little in a step. The usual size is the largest of late, and is
 * forgotten by a sixteenth in a step; nothing is usual before so many steps. */
#define ISO_JUMP R(64.0)
enum { ISO_USUAL_STEPS = 16 };

/* Whether the motion jumped within the step whose error this is. Without a branch on it. */
static inline void iso_watch(iso_progress *const progress, const real error)
{
    const bool known = progress->watched == ISO_USUAL_STEPS;
    const iso_bits leap = iso_less(ISO_JUMP * progress->usual, error) & ~iso_not_finite(error);
    progress->jumped = known & (leap != 0);
    progress->usual = iso_max(error, progress->usual - progress->usual / (real)ISO_USUAL_STEPS);
    progress->watched = (uint8_t)(progress->watched + !known);
}

/* Advances the n states of x[ISO_METHOD_STATE(recipe, n)] by h with u and p held. lu[eq->factors] only for implicit
 * methods, work[ISO_METHOD_WORK(recipe, n)]. */
ISO_INLINE void iso_method_step(const unsigned recipe, const size_t n, const iso_equations *const eq, const real h,
                                real *const x, const real *const u, const real *const p, real *const lu,
                                real *const work, iso_progress *const progress)
{
    const iso_history history = iso_history_of(recipe, n, x);
    iso_derivative *const f = eq->derivative;
    real error = R(0.0);
    switch (ISO_METHOD_OF(recipe)) {
    case ISO_EULER:
        error = iso_explicit_step(&iso_tableau_euler, &history, f, h, u, p, work);
        break;
    case ISO_HEUN:
        error = iso_explicit_step(&iso_tableau_heun, &history, f, h, u, p, work);
        break;
    case ISO_RK4:
        error = iso_explicit_step(&iso_tableau_rk4, &history, f, h, u, p, work);
        break;
    case ISO_AB4:
        error = iso_ab4_step(&history, f, h, u, p, work);
        break;
    case ISO_SEMI_IMPLICIT:
        error = iso_semi_implicit_step(&history, eq, h, u, p, work);
        break;
    case ISO_ABM4:
        error = iso_abm4_step(&history, f, h, u, p, work, 1, true);
        break;
    case ISO_ABM4_PEC:
        error = iso_abm4_step(&history, f, h, u, p, work, 1, false);
        break;
    case ISO_ABM4_PECECE:
        error = iso_abm4_step(&history, f, h, u, p, work, 2, true);
        break;
    case ISO_BDF4:
        error = iso_bdf4_step(&history, eq, h, u, p, lu, work, (uint8_t)ISO_ITERATIONS_OF(recipe), &progress->residual);
        break;
    case ISO_ROSENBROCK:
        error = iso_rosenbrock_step(&history, eq, h, u, p, lu, work);
        break;
    default:
        break;
    }
    if (ISO_IS_CHECKED(recipe)) {
        progress->local_error = error;
    }
    if (ISO_IS_WATCHED(recipe)) {
        iso_watch(progress, error);
    }
}

/* For an explicit method: what it keeps of the derivatives that lead to x, the oldest first. work[ISO_PRIME_WORK(n)].
 */
static inline void iso_prime_explicit(const unsigned recipe, const iso_history *const history, iso_derivative *const f,
                                      const real h, const real *const u, const real *const p, real *const work)
{
    const size_t n = history->n;
    const uint8_t count = ISO_IS_ABM4(recipe) || ISO_CHECK_KEPT(recipe) == 0 ? ISO_AB4_STEPS : ISO_CHECK_KEPT(recipe);
    real *const moved = work;
    real *const at = work + n;
    real *const derivatives = work + 2 * n;
    iso_walk_back(n, f, h, history->x, u, p, count, ISO_IS_ABM4(recipe), derivatives, moved, at,
                  derivatives + ISO_ADAMS_DERIVATIVES * n);
    for (uint8_t past = count; past-- > 0;) {
        const real *const derivative = derivatives + past * n;
        if (ISO_IS_ABM4(recipe)) {
            iso_abm4_take_derivative(history, h, derivative);
        } else if (ISO_IS(recipe, ISO_AB4)) {
            iso_ab4_take_derivative(history, h, derivative);
        }
        iso_keep_derivative(history, h, derivative);
    }
    for (size_t s = 0; s < n && history->checked > 0; s++) {
        history->check[s] = moved[s] - history->check[s];
    }
}

/* Fills what the method keeps behind the states of x, before the first step or after a jump; the states stay as they
 * are. lu[eq->factors] only for bdf4, work[ISO_METHOD_PRIME_WORK(recipe, n)]. */
static inline void iso_method_prime(const unsigned recipe, const size_t n, const iso_equations *const eq, const real h,
                                    real *const x, const real *const u, const real *const p, real *const lu,
                                    real *const work)
{
    const iso_history history = iso_history_of(recipe, n, x);
    if (ISO_IS(recipe, ISO_BDF4)) {
        iso_bdf4_prime(&history, eq, h, u, p, lu, work);
    } else if (ISO_IS_IMPLICIT(recipe)) {
        iso_prime_constant(&history, eq->derivative, h, u, p, work);
    } else if (ISO_IS_PRIMED(recipe)) {
        iso_prime_explicit(recipe, &history, eq->derivative, h, u, p, work);
    }
}

#endif
