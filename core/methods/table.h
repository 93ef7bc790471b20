/* What follows from the columns of a method. All are constant expressions.
 *
 * A recipe is a method with its options: ISO_RK4, or ISO_BDF4 | ISO_COMPENSATED | ISO_ITERATIONS(3). A method is a
 * header with its kernel and its columns, and a row of the list (core/methods/all.h); all else follows from these.
 *
 * The columns of a method ISO_NAME are ISO_NAME_ORDER(r) and so on, for a recipe r:
 *
 *     ORDER         order
 *     STAGES        of an explicit method of one step, whose TABLEAU is the address of its table; else 0, and NULL
 *     EVALUATIONS   of the derivative in a step (adams: in a sub-step); SOLUTIONS with the factors of its Jacobian
 *     PAST          vectors of n reals that it keeps from step to step
 *     WORK, PRIME   vectors of n reals of work space, of a step and of PRIMES, the function that makes its history
 *     SUMS          of a step for each state, and PRODUCTS, besides the sum x + dx and those of a check that uses
 *                   derivatives
 *     KIND          how a step is made
 *
 * Its kernel is iso_name_step. Semi-implicit Euler is for mechanical plants: half of the states are positions, half
 * their rates. */
#ifndef ISO_CORE_METHODS_TABLE_H
#define ISO_CORE_METHODS_TABLE_H

#include "core/methods/explicit.h"

#ifndef ISO_METHOD_LIST
#error "include core/methods/all.h before, or the headers of the methods of a plant and a list of them"
#endif

/* How a step is made. */
enum {
    ISO_FROM_START, /* from the derivative at its start; a check also uses that at its end: iso_step_begun */
    ISO_PREDICTING, /* from a predictor; its difference to the result gives the error */
    ISO_CORRECTING, /* the same, and the derivative at the end is evaluated again; of smooth inputs in the next step */
    ISO_ITERATING,  /* from a predictor by Newton iterations, whose residual is reported */
    ISO_VARYING,    /* in sub-steps of its own, whose error is always reported in an iso_adams_state */
};

#define ISO_METHOD_CONSTANT(r, m, name) m,
typedef enum iso_method { ISO_METHOD_LIST(ISO_METHOD_CONSTANT, 0) ISO_METHODS } iso_method;

/* The names: an array of ISO_METHODS. */
#define ISO_METHOD_NAME_OF(r, m, name) [m] = #name,
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
    ISO_SETTLED =
        0x80, /* the plant moves the states after a step, and the estimate with them: core/methods/settled.h */
    ISO_PREPARED = 0x4000, /* the plant has prepared the first evaluation: `prepared` of iso_equations */
};

#define ISO_ITERATIONS(count) ((count) << 8) /* of Newton, for bdf4, below 64; default: 2 */

/* The parts of a recipe; constant expressions. */
#define ISO_METHOD_OF(recipe) ((recipe)&ISO_METHOD_BITS)
#define ISO_IS(recipe, method) (ISO_METHOD_OF(recipe) == (method))
#define ISO_ITERATIONS_OF(recipe) (((recipe) >> 8 & 63) == 0 ? 2 : (int)((recipe) >> 8 & 63))
#define ISO_IS_COMPENSATED(recipe) (((recipe)&ISO_COMPENSATED) != 0)
#define ISO_IS_CHECKED(recipe) (((recipe)&ISO_CHECKED) != 0)
#define ISO_IS_PREPARED(recipe) (((recipe)&ISO_PREPARED) != 0)
#define ISO_IS_SMOOTH(recipe) (((recipe)&ISO_SMOOTH) != 0)

/* Whether the error of a step is known only at the start of the next one, by a predictor and a corrector. */
#define ISO_IS_LATE(recipe) (ISO_IS_CHECKED(recipe) && ISO_IS_SMOOTH(recipe))

/* A column of its row; constant expressions of type int. */
#define ISO_COLUMN(recipe, column) (0 ISO_METHOD_LIST(column, recipe))
#define ISO_CELL(r, m, value) +ISO_IS(r, m) * (value)
#define ISO_ORDER_CELL(r, m, name) ISO_CELL(r, m, m##_ORDER(r))
#define ISO_STAGES_CELL(r, m, name) ISO_CELL(r, m, m##_STAGES(r))
#define ISO_EVALUATIONS_CELL(r, m, name) ISO_CELL(r, m, m##_EVALUATIONS(r))
#define ISO_SOLUTIONS_CELL(r, m, name) ISO_CELL(r, m, m##_SOLUTIONS(r))
#define ISO_PAST_CELL(r, m, name) ISO_CELL(r, m, m##_PAST(r))
#define ISO_WORK_CELL(r, m, name) ISO_CELL(r, m, m##_WORK(r))
#define ISO_PRIME_CELL(r, m, name) ISO_CELL(r, m, m##_PRIME(r))
#define ISO_SUMS_CELL(r, m, name) ISO_CELL(r, m, m##_SUMS(r))
#define ISO_PRODUCTS_CELL(r, m, name) ISO_CELL(r, m, m##_PRODUCTS(r))
#define ISO_KIND_CELL(r, m, name) ISO_CELL(r, m, m##_KIND(r))

#define ISO_ORDER_OF(recipe) ISO_COLUMN(recipe, ISO_ORDER_CELL)
#define ISO_STAGES_OF(recipe) ISO_COLUMN(recipe, ISO_STAGES_CELL)
#define ISO_EVALUATIONS_OF(recipe) ISO_COLUMN(recipe, ISO_EVALUATIONS_CELL)
#define ISO_SOLUTIONS_OF(recipe) ISO_COLUMN(recipe, ISO_SOLUTIONS_CELL)
#define ISO_SUMS_OF(recipe) ISO_COLUMN(recipe, ISO_SUMS_CELL)
#define ISO_PRODUCTS_OF(recipe) ISO_COLUMN(recipe, ISO_PRODUCTS_CELL)
#define ISO_PAST_KEPT(recipe) ISO_COLUMN(recipe, ISO_PAST_CELL)
#define ISO_KIND_OF(recipe) ISO_COLUMN(recipe, ISO_KIND_CELL)

/* Whether it has the factors of one Jacobian in a step. */
#define ISO_IS_IMPLICIT(recipe) (ISO_SOLUTIONS_OF(recipe) > 0)
#define ISO_IS_ITERATING(recipe) (ISO_KIND_OF(recipe) == ISO_ITERATING)
#define ISO_IS_VARYING(recipe) (ISO_KIND_OF(recipe) == ISO_VARYING)

/* Whether it keeps its part of the error of a step for the next one, as the last vector of its past. */
#define ISO_KEEPS_ERROR(recipe) (ISO_IS_LATE(recipe) && ISO_KIND_OF(recipe) == ISO_CORRECTING)

/* Whether a check uses derivatives of the steps before. */
#define ISO_CHECKS_DERIVATIVES(recipe) (ISO_IS_CHECKED(recipe) && ISO_KIND_OF(recipe) == ISO_FROM_START)

/* Whether it computes the error of every state, to which the correction of the states after the step is added. */
#define ISO_IS_SETTLED(recipe) (((recipe)&ISO_SETTLED) != 0 && (ISO_IS_CHECKED(recipe) || ISO_IS_VARYING(recipe)))

/* Whether discontinuities are detected: if steps are checked, and the method has a history. */
#define ISO_IS_WATCHED(recipe) (ISO_IS_CHECKED(recipe) && !ISO_IS_VARYING(recipe) && ISO_PAST_KEPT(recipe) > 0)

/* Whether it is an explicit method of one step, by a table: then it can be a rung of a ladder, and some of the states
 * can take sub-steps within a step (core/methods/multirate.h). */
#define ISO_IS_EXPLICIT(recipe) (ISO_STAGES_OF(recipe) > 0)

/* Whether a step reports its progress. */
#define ISO_HAS_PROGRESS(recipe) (ISO_IS_CHECKED(recipe) || ISO_IS_ITERATING(recipe) || ISO_IS_VARYING(recipe))

/* Whether the check is centred: of one-step methods of order four, whose error is that small. Not of methods with a
 * history, which a discontinuity in the last step must show to. */
#define ISO_IS_CENTRED(recipe)                                                                                         \
    (ISO_CHECKS_DERIVATIVES(recipe) && ISO_PAST_KEPT(recipe) == 0 && ISO_ORDER_OF(recipe) == 4)

/* Derivatives before the end of a step that its check uses: one more than the order. The leading term of an error can
 * pass through zero in all states at about the same time; then the next term decides. As many as there are formulas
 * for: of a method of order five as many as its order. */
#define ISO_CHECK_KEPT(recipe)                                                                                         \
    (ISO_IS_CENTRED(recipe)                             ? (int)ISO_CENTRED_KEPT                                        \
     : !ISO_CHECKS_DERIVATIVES(recipe)                  ? 0                                                            \
     : ISO_ORDER_OF(recipe) + 1 < ISO_ADAMS_DERIVATIVES ? ISO_ORDER_OF(recipe) + 1                                     \
                                                        : ISO_ADAMS_DERIVATIVES - 1)

/* The degree of the polynomial of smooth inputs: one less than the order, so that the order is kept; none where all
 * evaluations are at the start of a step. */
#define ISO_AT_STARTS(recipe) (ISO_KIND_OF(recipe) == ISO_FROM_START && ISO_PAST_KEPT(recipe) > 0)
#define ISO_DEGREE(recipe) (ISO_IS_SMOOTH(recipe) && !ISO_AT_STARTS(recipe) ? ISO_ORDER_OF(recipe) - 1 : 0)

/* Whether its estimate of the local error is without that of the extrapolation, which shows at the next sample only. */
#define ISO_TELLS_NO_INPUTS(recipe)                                                                                    \
    (ISO_KIND_OF(recipe) == ISO_PREDICTING || ISO_IS_ITERATING(recipe) || ISO_IS_VARYING(recipe))

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
#define ISO_BY_SINES(recipe) (ISO_STAGES_OF(recipe) > 1)
#define ISO_METHOD_SINES(recipe, angles, kept) (ISO_BY_SINES(recipe) ? 4 * (size_t)(angles) + (size_t)(kept) : 0)

/* Reals of work space of a step, without the factors of an implicit method; and of priming. Where the degree is above
 * zero, there is room for the inputs before it. Behind that of the method are the errors of all states, and the states,
 * where these are moved after the step. */
#define ISO_METHOD_ERRORS(recipe, n) ((n) * (size_t)ISO_COLUMN(recipe, ISO_WORK_CELL))
#define ISO_METHOD_WORK(recipe, n) (ISO_METHOD_ERRORS(recipe, n) + (ISO_IS_SETTLED(recipe) ? 2 * (size_t)(n) : 0))
#define ISO_METHOD_PRIME_WORK(recipe, n) (ISO_IS_PRIMED(recipe) ? (n) * (size_t)ISO_COLUMN(recipe, ISO_PRIME_CELL) : 1)

/* The table of an explicit method of one step; NULL of any other. */
ISO_INLINE const iso_tableau *iso_tableau_of(const unsigned recipe)
{
    switch (ISO_METHOD_OF(recipe)) {
#define ISO_TABLEAU_CASE(r, m, name)                                                                                   \
    case m:                                                                                                            \
        return m##_TABLEAU;
        ISO_METHOD_LIST(ISO_TABLEAU_CASE, recipe)
    default:
        return NULL;
    }
}

#endif
