/* Nodes from nodes: their derivatives, and the same operation on other operands. */
#include "tools/isoc/graph/rules.h"

#include "tools/isoc/graph/graph.h"

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

/* The derivative of a where the first is above the second, that of b where it is below: larger(a, b) for a and b,
 * min(a, b) for b and a. Where they are equal, that of either, or zero where one is a constant. */
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

/* b a^(b - 1) a' + a^b log(a) b' */
static node derivative_of_power(graph *g, node i, node a, node b, node da, node db)
{
    const node less = function(g, OP_POWER, a, sub(g, b, constant(g, 1.0)));
    const node by_base = is_zero(g, da) ? da : mul(g, mul(g, b, less), da);
    return is_zero(g, db) ? by_base : add(g, by_base, mul(g, mul(g, i, function(g, OP_LOG, a, 0)), db));
}

/* (x y' - y x') / (x^2 + y^2) */
static node derivative_of_angle(graph *g, node y, node x, node dy, node dx)
{
    const node rest = difference_of_products(g, x, dy, y, dx), square = sum_of_products(g, x, x, y, y);
    return divide(g, rest, square);
}

#define RULES_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, ...)                                                        \
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
ISOC_OPERATIONS(RULES_OF)

#define RULES_OF_CALL(NAME, WORD, HEADER, OPERANDS, VALUE, DERIVATIVE, ...)                                            \
    RULES_OF(NAME, OPERANDS, VALUE, DERIVATIVE, function(g, OP_##NAME, a, b), )
ISOC_FUNCTIONS(RULES_OF_CALL)

#define RULES_ROW(NAME, ...) [OP_##NAME] = {derivative_of_##NAME, again_##NAME},

const operator_rules rules[OPERATIONS] = {ISOC_OPERATIONS(RULES_ROW) ISOC_FUNCTIONS(RULES_ROW)};
