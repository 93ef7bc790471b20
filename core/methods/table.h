/* The table of methods, and the values that follow from a row. All are constant expressions.
 *
 * A recipe is a method with its options: ISO_RK4, or ISO_BDF4 | ISO_COMPENSATED | ISO_ITERATIONS(3). A method is a
 * kernel in its own file and a row of the table below; all else follows from the row.
 */
#ifndef ISO_CORE_METHODS_TABLE_H
#define ISO_CORE_METHODS_TABLE_H

#include "core/methods/ab4.h"
#include "core/methods/abm4.h"
#include "core/methods/adams.h"
#include "core/methods/bdf4.h"
#include "core/methods/euler.h"
#include "core/methods/heun.h"
#include "core/methods/rk4.h"
#include "core/methods/rosenbrock.h"
#include "core/methods/semi_implicit.h"

/* How a step is made. */
enum {
    ISO_FROM_START, /* from the derivative at its start; a check also uses that at its end: iso_step_begin */
    ISO_PREDICTING, /* from a predictor; its difference to the result gives the error */
    ISO_ITERATING,  /* the same, by Newton iterations, whose residual is reported */
    ISO_VARYING,    /* in sub-steps of its own, whose error is always reported in an iso_adams_state */
};

/* One row for each method. `r` is the recipe: a column may depend on it. Columns: the constant; the name in a scene;
 * order; evaluations, Jacobians and solutions of a step (adams: of a sub-step); vectors of n reals kept from step to
 * step, those of work space of a step, and of priming; sums and products of a step for each state, besides the sum x +
 * dx and those of the check of ISO_FROM_START; how a step is made; gamma of the factors at its start, or 0; the kernel;
 * the function that primes it. Semi-implicit Euler is for mechanical plants: half of the states are positions, half
 * their rates. */
/* clang-format off */
#define ISO_METHOD_LIST(X, r)                                                                                          \
    X(r, ISO_EULER, "euler", 1,  1, 0, 0,  0, 2, ISO_PRIME_VECTORS,  0, 1,                                             \
      ISO_FROM_START, ISO_SCALAR(0.0), iso_euler_step, iso_prime_check)                                                \
    X(r, ISO_HEUN, "heun", 2,  2, 0, 0,  0, 3, ISO_PRIME_VECTORS,  2, 2,                                               \
      ISO_FROM_START, ISO_SCALAR(0.0), iso_heun_step, iso_prime_check)                                                 \
    X(r, ISO_RK4, "rk4", 4,  4, 0, 0,  0, 5, ISO_PRIME_VECTORS,  6, 5,                                                 \
      ISO_FROM_START, ISO_SCALAR(0.0), iso_rk4_step, iso_prime_check)                                                  \
    X(r, ISO_AB4, "ab4", 4,  1, 0, 0,  ISO_AB4_SUMS, 1, ISO_PRIME_VECTORS,  3, 4,                                      \
      ISO_FROM_START, ISO_SCALAR(0.0), iso_ab4_step, iso_ab4_prime)                                                    \
    X(r, ISO_SEMI_IMPLICIT, "semi_implicit", 1,  1, 0, 0,  0, 1, ISO_PRIME_VECTORS,  0, 1,                             \
      ISO_FROM_START, ISO_SCALAR(0.0), iso_semi_implicit_step, iso_prime_check)                                        \
    X(r, ISO_ABM4, "abm4", 4,  2, 0, 0,                                                                                \
      ISO_ABM4_SUMS + ISO_IS_LATE(r), 2, ISO_PRIME_VECTORS,  7 + ISO_IS_CHECKED(r) + ISO_IS_LATE(r),                   \
      8 + 2 * ISO_IS_LATE(r),                                                                                          \
      ISO_PREDICTING, ISO_SCALAR(0.0), iso_abm4_step, iso_abm4_prime)                                                  \
    X(r, ISO_ABM4_PEC, "abm4_pec", 4,  1, 0, 0,  ISO_ABM4_SUMS, 2, ISO_PRIME_VECTORS,  7 + ISO_IS_CHECKED(r), 8,       \
      ISO_PREDICTING, ISO_SCALAR(0.0), iso_abm4_pec_step, iso_abm4_pec_prime)                                          \
    X(r, ISO_ABM4_PECECE, "abm4_pecece", 4,  3, 0, 0,                                                                  \
      ISO_ABM4_SUMS + ISO_IS_LATE(r), 2, ISO_PRIME_VECTORS,  9 + ISO_IS_CHECKED(r) + ISO_IS_LATE(r),                   \
      9 + 2 * ISO_IS_LATE(r),                                                                                          \
      ISO_PREDICTING, ISO_SCALAR(0.0), iso_abm4_pecece_step, iso_abm4_prime)                                           \
    X(r, ISO_BDF4, "bdf4", 4,  ISO_ITERATIONS_OF(r), 1, ISO_ITERATIONS_OF(r),                                          \
      ISO_BDF4_STEPS, 5, ISO_BDF4_PRIME_VECTORS,                                                                       \
      7 + 5 * ISO_ITERATIONS_OF(r) + 5 * ISO_IS_CHECKED(r), 7 + ISO_ITERATIONS_OF(r) + 3 * ISO_IS_CHECKED(r),          \
      ISO_ITERATING, ISO_SCALAR(0.0), iso_bdf4_step, iso_bdf4_prime)                                                   \
    X(r, ISO_ROSENBROCK, "rosenbrock", 3,  2 + ISO_IS_SMOOTH(r), 1, 3 + ISO_IS_CHECKED(r),                             \
      0, ISO_ROSENBROCK_VECTORS + ISO_IS_SMOOTH(r), 1,  6 + 4 * ISO_IS_SMOOTH(r), 8 + 3 * ISO_IS_SMOOTH(r),            \
      ISO_FROM_START, iso_table_ros3.gamma, iso_rosenbrock_step, iso_prime_even)                                       \
    X(r, ISO_ADAMS, "adams", 4,  2, 0, 0,  ISO_ADAMS_ROWS, ISO_ADAMS_VECTORS, ISO_ADAMS_VECTORS,  0, 0,                \
      ISO_VARYING, ISO_SCALAR(0.0), iso_adams_step, iso_adams_prime)
/* clang-format on */

#define ISO_METHOD_CONSTANT(r, constant, ...) constant,
typedef enum iso_method { ISO_METHOD_LIST(ISO_METHOD_CONSTANT, 0) ISO_METHODS } iso_method;

/* The names: an array of ISO_METHODS. */
#define ISO_METHOD_NAME_OF(r, constant, name, ...) [constant] = (name),
#define ISO_METHOD_NAMES                                                                                               \
    {                                                                                                                  \
        ISO_METHOD_LIST(ISO_METHOD_NAME_OF, 0)                                                                         \
    }

/* Options. An option that is not chosen costs nothing. */
enum {
    ISO_METHOD_BITS = 0xF,
    ISO_COMPENSATED = 0x10, /* compensated sums of increments (Kahan-Babuska) */
    ISO_CHECKED = 0x20,     /* the local error of every step is estimated */
    ISO_SMOOTH = 0x40,      /* inputs are samples of continuous signals: core/methods/inputs.h */
    ISO_SETTLED = 0x80, /* the plant moves the states after a step, and the estimate with them: iso_method_settled */
};

#define ISO_ITERATIONS(count) ((count) << 8) /* of Newton, for bdf4; default: 2 */

/* The parts of a recipe; constant expressions. */
#define ISO_METHOD_OF(recipe) ((recipe)&ISO_METHOD_BITS)
#define ISO_IS(recipe, method) (ISO_METHOD_OF(recipe) == (method))
#define ISO_ITERATIONS_OF(recipe) (((recipe) >> 8) == 0 ? 2 : (int)((recipe) >> 8))
#define ISO_IS_COMPENSATED(recipe) (((recipe)&ISO_COMPENSATED) != 0)
#define ISO_IS_CHECKED(recipe) (((recipe)&ISO_CHECKED) != 0)
#define ISO_IS_SMOOTH(recipe) (((recipe)&ISO_SMOOTH) != 0)

/* Whether the error of a step is known only at the start of the next one, by a predictor and a corrector. */
#define ISO_IS_LATE(recipe) (ISO_IS_CHECKED(recipe) && ISO_IS_SMOOTH(recipe))

/* Whether it keeps its part of the error of a step until then. */
#define ISO_KEEPS_ERROR(recipe) (ISO_IS_LATE(recipe) && (ISO_IS(recipe, ISO_ABM4) || ISO_IS(recipe, ISO_ABM4_PECECE)))

/* A file in which all steps are of a few methods may define this before it includes the table: #define ISO_ONLY_METHODS
 * (1 << ISO_RK4 | 1 << ISO_EULER). The compiler then sees no other row and no other kernel, which saves it up to two
 * thirds of its time; no bit changes. There the columns of another method are 0, its work space is an error of the
 * compiler, and a step of it stops the program. */
#ifdef ISO_ONLY_METHODS
#define ISO_IS_SEEN(method) ((ISO_ONLY_METHODS >> (method)&1) != 0)
#define ISO_HAS_ROW(recipe, method) (ISO_IS_SEEN(method) && ISO_IS(recipe, method))
#define ISO_SEEN_ROWS(recipe) sizeof(char[ISO_IS_SEEN(ISO_METHOD_OF(recipe)) ? 1 : -1]) /* 1 */
#else
#define ISO_IS_SEEN(method) true
#define ISO_HAS_ROW(recipe, method) ISO_IS(recipe, method)
#define ISO_SEEN_ROWS(recipe) 1
#endif

/* A column of its row; constant expressions of type int. */
#define ISO_COLUMN(recipe, column) (0 ISO_METHOD_LIST(column, recipe))
#define ISO_CELL(r, constant, value) +ISO_HAS_ROW(r, constant) * (value)
#define ISO_ORDER_CELL(r, m, name, order, ...) ISO_CELL(r, m, order)
#define ISO_EVALUATIONS_CELL(r, m, name, order, evaluations, ...) ISO_CELL(r, m, evaluations)
#define ISO_JACOBIANS_CELL(r, m, name, order, evaluations, jacobians, ...) ISO_CELL(r, m, jacobians)
#define ISO_SOLUTIONS_CELL(r, m, name, order, evaluations, jacobians, solutions, ...) ISO_CELL(r, m, solutions)
#define ISO_PAST_CELL(r, m, name, order, f, j, s, past, ...) ISO_CELL(r, m, past)
#define ISO_WORK_CELL(r, m, name, order, f, j, s, past, work, ...) ISO_CELL(r, m, work)
#define ISO_PRIME_CELL(r, m, name, order, f, j, s, past, work, prime, ...) ISO_CELL(r, m, prime)
#define ISO_SUMS_CELL(r, m, name, order, f, j, s, past, work, prime, sums, ...) ISO_CELL(r, m, sums)
#define ISO_PRODUCTS_CELL(r, m, name, order, f, j, s, past, work, prime, sums, products, ...) ISO_CELL(r, m, products)
#define ISO_KIND_CELL(r, m, name, order, f, j, s, past, work, prime, sums, products, kind, ...) ISO_CELL(r, m, kind)

#define ISO_ORDER_OF(recipe) ISO_COLUMN(recipe, ISO_ORDER_CELL)
#define ISO_EVALUATIONS_OF(recipe) ISO_COLUMN(recipe, ISO_EVALUATIONS_CELL)
#define ISO_JACOBIANS_OF(recipe) ISO_COLUMN(recipe, ISO_JACOBIANS_CELL)
#define ISO_SOLUTIONS_OF(recipe) ISO_COLUMN(recipe, ISO_SOLUTIONS_CELL)
#define ISO_SUMS_OF(recipe) ISO_COLUMN(recipe, ISO_SUMS_CELL)
#define ISO_PRODUCTS_OF(recipe) ISO_COLUMN(recipe, ISO_PRODUCTS_CELL)
#define ISO_PAST_KEPT(recipe) ISO_COLUMN(recipe, ISO_PAST_CELL)
#define ISO_KIND_OF(recipe) ISO_COLUMN(recipe, ISO_KIND_CELL)

#define ISO_IS_IMPLICIT(recipe) (ISO_JACOBIANS_OF(recipe) > 0)
#define ISO_IS_ITERATING(recipe) (ISO_KIND_OF(recipe) == ISO_ITERATING)
#define ISO_IS_VARYING(recipe) (ISO_KIND_OF(recipe) == ISO_VARYING)

/* Whether a check uses derivatives of the steps before. */
#define ISO_CHECKS_DERIVATIVES(recipe) (ISO_IS_CHECKED(recipe) && ISO_KIND_OF(recipe) == ISO_FROM_START)

/* Whether it computes the error of every state, to which the correction of the states after the step is added. */
#define ISO_IS_SETTLED(recipe) (((recipe)&ISO_SETTLED) != 0 && (ISO_IS_CHECKED(recipe) || ISO_IS_VARYING(recipe)))

/* Whether discontinuities are detected: if steps are checked, and the method has a history. */
#define ISO_IS_WATCHED(recipe) (ISO_IS_CHECKED(recipe) && !ISO_IS_VARYING(recipe) && ISO_PAST_KEPT(recipe) > 0)

/* Whether some of the states can take sub-steps within a step (core/methods/multirate.h): an explicit method of one
 * step. */
#define ISO_TAKES_SUBSTEPS(recipe) (ISO_IS(recipe, ISO_EULER) || ISO_IS(recipe, ISO_HEUN) || ISO_IS(recipe, ISO_RK4))

/* Whether a step reports its progress. */
#define ISO_HAS_PROGRESS(recipe) (ISO_IS_CHECKED(recipe) || ISO_IS_ITERATING(recipe) || ISO_IS_VARYING(recipe))

/* Whether the check is centred: of one-step methods of order four, whose error is that small. Not of methods with a
 * history, which a discontinuity in the last step must show to. */
#define ISO_IS_CENTRED(recipe)                                                                                         \
    (ISO_CHECKS_DERIVATIVES(recipe) && ISO_PAST_KEPT(recipe) == 0 && ISO_ORDER_OF(recipe) == 4)

/* Derivatives before the end of a step that its check uses: one more than the order. The leading term of an error can
 * pass through zero in all states at about the same time; then the next term decides. */
#define ISO_CHECK_KEPT(recipe)                                                                                         \
    (ISO_IS_CENTRED(recipe) ? (int)ISO_CENTRED_KEPT : ISO_CHECKS_DERIVATIVES(recipe) ? ISO_ORDER_OF(recipe) + 1 : 0)

/* The degree of the polynomial of smooth inputs: one less than the order, so that the order is kept; none where all
 * evaluations are at the start of a step. */
#define ISO_AT_STARTS(recipe) (ISO_KIND_OF(recipe) == ISO_FROM_START && ISO_PAST_KEPT(recipe) > 0)
#define ISO_DEGREE(recipe) (ISO_IS_SMOOTH(recipe) && !ISO_AT_STARTS(recipe) ? ISO_ORDER_OF(recipe) - 1 : 0)

/* Whether its estimate of the local error is without that of the extrapolation, which shows at the next sample only. */
#define ISO_TELLS_NO_INPUTS(recipe) (ISO_IS(recipe, ISO_ABM4_PEC) || ISO_IS_ITERATING(recipe) || ISO_IS_VARYING(recipe))

/* Reals behind u: samples of the inputs. */
#define ISO_METHOD_SAMPLES(recipe, inputs) ISO_SAMPLE_REALS(ISO_DEGREE(recipe), inputs)

/* Vectors of n reals behind the state: the history of the method, its check, the compensation. */
#define ISO_HISTORY_KEPT(recipe) (ISO_PAST_KEPT(recipe) + ISO_CHECK_KEPT(recipe))
#define ISO_VECTORS_KEPT(recipe) (ISO_HISTORY_KEPT(recipe) + (ISO_IS_COMPENSATED(recipe) ? 1 : 0))

/* Whether there is a history, which must be primed before the first step. */
#define ISO_IS_PRIMED(recipe) (ISO_HISTORY_KEPT(recipe) > 0)

/* Reals of x: the n states, and behind them the history. */
#define ISO_METHOD_STATE(recipe, n) ((n) * (size_t)(1 + ISO_VECTORS_KEPT(recipe)))

/* Reals of work space of a step before those of the method, where its stages take sines and cosines of so many angles
 * from those of its start: an explicit method of several stages. First those of the start, then those of a stage, then
 * the values of it that the plant keeps. */
#define ISO_BY_SINES(recipe) (ISO_IS(recipe, ISO_HEUN) || ISO_IS(recipe, ISO_RK4))
#define ISO_METHOD_SINES(recipe, angles, kept) (ISO_BY_SINES(recipe) ? 4 * (size_t)(angles) + (size_t)(kept) : 0)

/* Reals of work space of a step, without the factors of an implicit method; and of priming. Where the degree is above
 * zero, there is room for the inputs before it. Behind that of the method are the errors of all states, and the states,
 * where these are moved after the step. */
#define ISO_METHOD_ERRORS(recipe, n) ((n) * (size_t)ISO_COLUMN(recipe, ISO_WORK_CELL))
#define ISO_METHOD_WORK(recipe, n)                                                                                     \
    (ISO_SEEN_ROWS(recipe) * (ISO_METHOD_ERRORS(recipe, n) + (ISO_IS_SETTLED(recipe) ? 2 * (size_t)(n) : 0)))
#define ISO_METHOD_PRIME_WORK(recipe, n)                                                                               \
    (ISO_SEEN_ROWS(recipe) * (ISO_IS_PRIMED(recipe) ? (n) * (size_t)ISO_COLUMN(recipe, ISO_PRIME_CELL) : 1))

#endif
