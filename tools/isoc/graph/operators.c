#include "tools/isoc/graph/operators.h"

#include <float.h>
#include <math.h>

#include "tools/isoc/base/elementary.h"
#include "tools/isoc/graph/graph.h"

/* Functions of constants are the target's own (in double), so that every host folds them to the same bits. */
#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/pieces.h"
#include "core/numbers/root.h"
#include "core/numbers/tanh.h"
#include "core/numbers/turns.h"

_Static_assert(sizeof(real) == sizeof(double), "isoc folds constants in double: -DISO_REAL_DOUBLE");

/* (a / b)' = (a' - (a / b) b') / b, with one division for all derivatives. */
static node derivative_of_quotient(graph *g, node quotient, node b, node da, node db)
{
    const node rest = sub(g, da, mul(g, quotient, db)), inverse = divide(g, constant(g, 1.0), b);
    return mul(g, rest, inverse);
}

/* sign(a) a', with sign(0) = 0. */
static node derivative_of_magnitude(graph *g, node a, node da)
{
    const node zero = constant(g, 0.0);
    const node plus = above(g, a, zero), minus = above(g, zero, a);
    const node sign = sub(g, plus, minus);
    return mul(g, sign, da);
}

/* That of a where the first is above the second, that of b where it is below: larger(a, b) for a and b, min(a, b) for b
 * and a. Where they are equal, that of either, or zero where one is a constant. */
static node derivative_of_chosen(graph *g, node first, node second, node da, node db)
{
    if (is_zero(g, da)) {
        return mul(g, above(g, second, first), db);
    }
    const node rest = sub(g, da, db), chosen = mul(g, above(g, first, second), rest);
    return add(g, db, chosen);
}

/* -w^3 a' / 2, with one factor after the other: where a is zero, so is a', and no product on the way overflows. */
static node derivative_of_inverse_root(graph *g, node w, node da)
{
    const node half = mul(g, constant(g, -0.5), da);
    return mul(g, mul(g, mul(g, half, w), w), w);
}

/* (x y' - y x') / (x^2 + y^2) */
static node derivative_of_angle(graph *g, node y, node x, node dy, node dx)
{
    const node rest = difference_of_products(g, x, dy, y, dx), square = sum_of_products(g, x, x, y, y);
    return divide(g, rest, square);
}

/* Of constants, the nearest double where there is one; what the target gives outside of the function's domain. */
static double value_of_exponential(double x)
{
    return fabs(x) <= 700.0 ? elementary_exp(x) : iso_exp(x);
}

static double value_of_logarithm(double x)
{
    return x >= DBL_MIN && x <= DBL_MAX ? elementary_log(x) : iso_log(x);
}

static double value_of_angle(double y, double x)
{
    const bool is_known = fabs(y) <= 1e300 && fabs(x) <= 1e300 && (y != 0.0 || x != 0.0);
    return is_known ? elementary_atan2(y, x) : iso_atan2(y, x);
}

#define VALUE_OF_LEAF(NAME, ARRAY, TEXT, VALUE)                                                                        \
    static double value_of_##NAME(const graph_node *n, const evaluation *at, double a, double b)                       \
    {                                                                                                                  \
        (void)n, (void)at, (void)a, (void)b;                                                                           \
        return VALUE;                                                                                                  \
    }
ISOC_LEAVES(VALUE_OF_LEAF)

static double value_of_timed(const graph_node *n, const evaluation *at, double a, double b)
{
    (void)n, (void)at, (void)a, (void)b;
    return 0.0;
}

#define FUNCTIONS_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, ...)                                                    \
    static double value_of_##NAME(const graph_node *n, const evaluation *at, double a, double b)                       \
    {                                                                                                                  \
        (void)n, (void)at, (void)a, (void)b;                                                                           \
        return VALUE;                                                                                                  \
    }                                                                                                                  \
    static node derivative_of_##NAME(graph *g, node i, node da, node db)                                               \
    {                                                                                                                  \
        const node a = g->nodes[i].a, b = g->nodes[i].b;                                                               \
        (void)a, (void)b, (void)da, (void)db;                                                                          \
        return DERIVATIVE;                                                                                             \
    }                                                                                                                  \
    static node again_##NAME(graph *g, node a, node b)                                                                 \
    {                                                                                                                  \
        (void)a, (void)b;                                                                                              \
        return AGAIN;                                                                                                  \
    }
ISOC_OPERATIONS(FUNCTIONS_OF)

#define FUNCTIONS_OF_CALL(NAME, WORD, HEADER, OPERANDS, VALUE, DERIVATIVE, ...)                                        \
    FUNCTIONS_OF(NAME, OPERANDS, VALUE, DERIVATIVE, function(g, OP_##NAME, a, b), )
ISOC_FUNCTIONS(FUNCTIONS_OF_CALL)

#define ROW_OF_LEAF(NAME, ARRAY, TEXT, VALUE)                                                                          \
    [OP_##NAME] = {KIND_LEAF, 0, #NAME, ARRAY, TEXT, .binds = BINDS_WHOLE, .place = IN_PLACE, .value = value_of_##NAME},
#define ROW_OF_TIMED(NAME, TEXT, BINDS)                                                                                \
    [OP_##NAME] = {                                                                                                    \
        KIND_TIMED, 0, #NAME, NULL, TEXT, .binds = BINDS_##BINDS, .place = IN_PLACE, .value = value_of_timed},
#define ROW_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, TEXT, BINDS, LEAST_A, LEAST_B, PLACE, ADD, MUL, DIV, SINCOS)  \
    [OP_##NAME] = {KIND_OPERATION,                                                                                     \
                   OPERANDS,                                                                                           \
                   #NAME,                                                                                              \
                   NULL,                                                                                               \
                   TEXT,                                                                                               \
                   NULL,                                                                                               \
                   NULL,                                                                                               \
                   BINDS_##BINDS,                                                                                      \
                   BINDS_##LEAST_A,                                                                                    \
                   BINDS_##LEAST_B,                                                                                    \
                   PLACE,                                                                                              \
                   {ADD, MUL, DIV, SINCOS},                                                                            \
                   value_of_##NAME,                                                                                    \
                   derivative_of_##NAME,                                                                               \
                   again_##NAME},

#define ROW_OF_CALL(NAME, WORD, HEADER, OPERANDS, VALUE, DERIVATIVE, ADD, MUL, DIV)                                    \
    [OP_##NAME] = {KIND_OPERATION,                                                                                     \
                   OPERANDS,                                                                                           \
                   #NAME,                                                                                              \
                   NULL,                                                                                               \
                   OPERANDS == 1 ? "iso_" #WORD "(@a)" : "iso_" #WORD "(@a, @b)",                                      \
                   "iso_" #WORD "(",                                                                                   \
                   "core/numbers/" #HEADER ".h",                                                                       \
                   BINDS_WHOLE,                                                                                        \
                   BINDS_SUM,                                                                                          \
                   BINDS_SUM,                                                                                          \
                   DECLARED,                                                                                           \
                   {ADD, MUL, DIV, 0},                                                                                 \
                   value_of_##NAME,                                                                                    \
                   derivative_of_##NAME,                                                                               \
                   again_##NAME},

const operator_row operators[OPERATIONS] = {ISOC_LEAVES(ROW_OF_LEAF) ISOC_TIMED(ROW_OF_TIMED) ISOC_OPERATIONS(ROW_OF)
                                                ISOC_FUNCTIONS(ROW_OF_CALL)};
