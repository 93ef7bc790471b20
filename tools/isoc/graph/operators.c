#include <float.h>
#include <math.h>

#include "tools/isoc/base/numbers.h"
#include "tools/isoc/graph/timed.h"

/* Functions of constants are the target's own (in double), so that every host folds them to the same bits. */
#include "core/numbers/angle.h"
#include "core/numbers/exp.h"
#include "core/numbers/log.h"
#include "core/numbers/noise.h"
#include "core/numbers/pieces.h"
#include "core/numbers/power.h"
#include "core/numbers/root.h"
#include "core/numbers/tanh.h"
#include "core/numbers/turns.h"

_Static_assert(sizeof(real) == sizeof(double), "isoc folds constants in double: -DISO_REAL_DOUBLE");

/* For a constant, the nearest double where there is one; outside the function's domain, the value that the target
 * computes. */
static double value_of_exponential(double x)
{
    return fabs(x) <= 700.0 ? elementary_exp(x) : iso_exp(x);
}

static double value_of_logarithm(double x)
{
    return x >= DBL_MIN && x <= DBL_MAX ? elementary_log(x) : iso_log(x);
}

static double value_of_power_of(double x, double y)
{
    const bool is_known = x >= DBL_MIN && x <= DBL_MAX && fabs(y * iso_log(x)) <= 700.0;
    return is_known ? elementary_power(x, y) : iso_power(x, y);
}

static double value_of_angle(double y, double x)
{
    const bool is_known = fabs(y) <= 1e300 && fabs(x) <= 1e300 && (y != 0.0 || x != 0.0);
    return is_known ? elementary_atan2(y, x) : iso_atan2(y, x);
}

/* The whole part and the fraction of a number of ticks; and the table of a node. */
static uint32_t whole(double ticks)
{
    return (uint32_t)floor(ticks);
}

static double fraction(double ticks)
{
    return ticks - floor(ticks);
}

static const tick_table *table_of(const graph *g, const graph_node *n)
{
    return &g->tables->all[n->index];
}

static double value_of_chirp(const tick_table *t, uint64_t tick)
{
    const iso_chirp_table sweep = sweep_of(t);
    return iso_chirp(tick, &sweep);
}

static double value_of_lines(const tick_table *t, uint64_t tick)
{
    return iso_on_lines(tick, &(iso_lines){t->words, t->values, t->slopes, (uint32_t)t->count});
}

#define VALUE_OF(NAME, OPERANDS, VALUE, ...)                                                                           \
    static double value_of_##NAME(const graph *g, const graph_node *n, const evaluation *at, double a, double b)       \
    {                                                                                                                  \
        (void)g, (void)n, (void)at, (void)a, (void)b;                                                                  \
        return VALUE;                                                                                                  \
    }
ISOC_OPERATIONS(VALUE_OF)

#define VALUE_OF_TIMED(NAME, TEXT, BINDS, VALUE)                                                                       \
    static double value_of_##NAME(const graph *g, const graph_node *n, const evaluation *at, double a, double b)       \
    {                                                                                                                  \
        const uint64_t tick = at->tick;                                                                                \
        (void)g, (void)a, (void)b;                                                                                     \
        return VALUE;                                                                                                  \
    }
ISOC_TIMED(VALUE_OF_TIMED)

#define VALUE_OF_LEAF(NAME, ARRAY, TEXT, VALUE) VALUE_OF(NAME, 0, VALUE, )
ISOC_LEAVES(VALUE_OF_LEAF)

#define VALUE_OF_CALL(NAME, WORD, HEADER, OPERANDS, VALUE, ...) VALUE_OF(NAME, OPERANDS, VALUE, )
ISOC_FUNCTIONS(VALUE_OF_CALL)

#define ROW_OF_LEAF(NAME, ARRAY, TEXT, VALUE)                                                                          \
    [OP_##NAME] = {KIND_LEAF, 0, #NAME, ARRAY, TEXT, .binds = BINDS_WHOLE, .form = INLINE, .value = value_of_##NAME},
#define ROW_OF_TIMED(NAME, TEXT, BINDS, VALUE)                                                                         \
    [OP_##NAME] = {KIND_TIMED, 0, #NAME, NULL, TEXT, .binds = BINDS_##BINDS, .form = INLINE, .value = value_of_##NAME},
#define ROW_OF(NAME, OPERANDS, VALUE, DERIVATIVE, AGAIN, TEXT, BINDS, LEAST_A, LEAST_B, PLACE, ADD, MUL, DIV, SINCOS)  \
    [OP_##NAME] = {.kind = KIND_OPERATION,                                                                             \
                   .operands = OPERANDS,                                                                               \
                   .name = #NAME,                                                                                      \
                   .text = TEXT,                                                                                       \
                   .binds = BINDS_##BINDS,                                                                             \
                   .least_a = BINDS_##LEAST_A,                                                                         \
                   .least_b = BINDS_##LEAST_B,                                                                         \
                   .form = PLACE,                                                                                      \
                   .cost = {ADD, MUL, DIV, SINCOS},                                                                    \
                   .value = value_of_##NAME},

/* A call stands in the code as a whole, and its operands are sums at the least. */
#define TEXT_OF_CALL(WORD, OPERANDS) OPERANDS == 1 ? "iso_" #WORD "(@a)" : "iso_" #WORD "(@a, @b)"
#define ROW_OF_CALL(NAME, WORD, HEADER, OPERANDS, VALUE, DERIVATIVE, ADD, MUL, DIV)                                    \
    ROW_OF(NAME, OPERANDS, , , , TEXT_OF_CALL(WORD, OPERANDS), WHOLE, SUM, SUM, DECLARED, ADD, MUL, DIV, 0)            \
    [OP_##NAME].call = "iso_" #WORD "(", [OP_##NAME].header = "core/numbers/" #HEADER ".h",

const operator_row operators[OPERATIONS] = {ISOC_LEAVES(ROW_OF_LEAF) ISOC_TIMED(ROW_OF_TIMED) ISOC_OPERATIONS(ROW_OF)
                                                ISOC_FUNCTIONS(ROW_OF_CALL)};
