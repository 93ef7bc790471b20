#include "tools/isoc/graph/operators.h"

#include <math.h>

#include "tools/isoc/graph/graph.h"

/* The trigonometry of constants is the target's own (in double), so that every host folds them to the same bits. */
#include "core/numbers/root.h"
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

/* That of the larger; where they are equal, that of either, or zero where one is a constant. */
static node derivative_of_larger(graph *g, node a, node b, node da, node db)
{
    if (is_zero(g, da)) {
        return mul(g, above(g, b, a), db);
    }
    const node rest = sub(g, da, db), chosen = mul(g, above(g, a, b), rest);
    return add(g, db, chosen);
}

/* -w^3 a' / 2, with one factor after the other: where a is zero, so is a', and no product on the way overflows. */
static node derivative_of_inverse_root(graph *g, node w, node da)
{
    const node half = mul(g, constant(g, -0.5), da);
    return mul(g, mul(g, mul(g, half, w), w), w);
}

#define VALUE_OF_LEAF(NAME, ARRAY, TEXT, VALUE)                                                                        \
    static double value_of_##NAME(const graph_node *of, const evaluation *at, double a, double b)                      \
    {                                                                                                                  \
        (void)of, (void)at, (void)a, (void)b;                                                                          \
        return VALUE;                                                                                                  \
    }
ISOC_LEAVES(VALUE_OF_LEAF)

static double value_of_timed(const graph_node *of, const evaluation *at, double a, double b)
{
    (void)of, (void)at, (void)a, (void)b;
    return 0.0;
}

#define FUNCTIONS_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, ...)                                                    \
    static double value_of_##NAME(const graph_node *of, const evaluation *at, double a, double b)                      \
    {                                                                                                                  \
        (void)of, (void)at, (void)a, (void)b;                                                                          \
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

#define ROW_OF_LEAF(NAME, ARRAY, TEXT, VALUE)                                                                          \
    [OP_##NAME] = {KIND_LEAF, 0, #NAME, ARRAY, TEXT, BINDS_WHOLE, .place = IN_PLACE, .value = value_of_##NAME},
#define ROW_OF_TIMED(NAME, TEXT, BINDS)                                                                                \
    [OP_##NAME] = {KIND_TIMED, 0, #NAME, NULL, TEXT, BINDS_##BINDS, .place = IN_PLACE, .value = value_of_timed},
#define ROW_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, TEXT, BINDS, LEAST_A, LEAST_B, PLACE, ADD, MUL, DIV, SINCOS)  \
    [OP_##NAME] = {KIND_OPERATION,                                                                                     \
                   OPERANDS,                                                                                           \
                   #NAME,                                                                                              \
                   NULL,                                                                                               \
                   TEXT,                                                                                               \
                   BINDS_##BINDS,                                                                                      \
                   BINDS_##LEAST_A,                                                                                    \
                   BINDS_##LEAST_B,                                                                                    \
                   PLACE,                                                                                              \
                   {ADD, MUL, DIV, SINCOS},                                                                            \
                   value_of_##NAME,                                                                                    \
                   derivative_of_##NAME,                                                                               \
                   again_##NAME},

const operator_row operators[OPERATIONS] = {ISOC_LEAVES(ROW_OF_LEAF) ISOC_TIMED(ROW_OF_TIMED) ISOC_OPERATIONS(ROW_OF)};
