/* All operators of nodes: one row for each. A new one is a row here and a function in tools/isoc/graph/graph.h that
 * makes its nodes; a row without one of its cells, as the derivative, does not compile.
 *
 * The C text of an operator has @a and @b where its operands stand, @t for the pair of sine and cosine of its operand,
 * @x, @u, @p for the name of a state, input, parameter, @X for a state's place in its array, and @i for its index. Of
 * an operator with numbers of its own, @1 and @2 are these numbers, @w and @f the whole part and the fraction of the
 * first, @W the whole part of the second, @v and @s both as phases: 2^64 is a turn. */
#ifndef ISOC_GRAPH_OPERATORS_H
#define ISOC_GRAPH_OPERATORS_H

#include <stdbool.h>
#include <stdint.h>

/* A node's index in its graph. */
typedef int32_t node;

struct graph;
struct graph_node;

/* How tightly an expression binds, for parentheses. */
typedef enum binding { BINDS_SUM, BINDS_PRODUCT, BINDS_WHOLE } binding;

/* Whether the code declares a variable for a node with a name or several uses, or always writes its text in place. */
typedef enum writing_form { DECLARED, INLINE } writing_form;

/* Its operations; comparisons and signs count as additions. */
typedef struct operations {
    int add, mul, div, sincos; /* sine and cosine of one angle count once */
} operations;

/* Where a graph is evaluated. States and inputs that are NULL count as zero. */
typedef struct evaluation {
    const double *x, *u, *p;
    uint64_t tick;        /* of functions of the tick: 0 is the start */
    bool rounds_to_float; /* each number: for + - * / the bits that float arithmetic gives (Figueroa 1995) */
} evaluation;

/* clang-format off */
/* Leaves. The array is the one that they are read from at the head of a function, or NULL.
 * LEAF(name, array, C text, value at the evaluation `at` of the node `n`) */
#define ISOC_LEAVES(LEAF)                                                                                              \
    LEAF(CONSTANT, NULL, "@1", n->value)                       /* value */                                            \
    LEAF(STATE, "x", "@x", at->x == NULL ? 0.0 : at->x[n->index])                                                     \
    LEAF(INPUT, "u", "@u", at->u == NULL ? 0.0 : at->u[n->index])                                                     \
    LEAF(PARAMETER, "p", "@p", at->p[n->index])                                                                       \
    LEAF(RIGHT, "d", "r_@x", 0.0)                               /* a right side to be solved for */                    \
    LEAF(FACTOR, "lu", "lu_@i", 0.0)                                                                                   \
    LEAF(TURNS, NULL, "iso_real_of_turns(memory->turns[@i])", 0.0) /* of a continuous joint */                         \
    LEAF(STEP, NULL, "hb", 0.0)                                 /* the step times a coefficient of the method */       \
    LEAF(LOCAL_ERROR, NULL, "progress->local_error", 0.0)        /* of a checked step */                               \
    LEAF(RESIDUAL, NULL, "progress->residual", 0.0)              /* of Newton's iteration */                           \
    LEAF(MULTIPLIER, NULL, "", 0.0)                             /* lambda, until its solution takes its place */       \
    LEAF(HELD, NULL, "h[@i]", 0.0)                              /* a value that is constant within a step */           \
    LEAF(KEPT, NULL, "kept[@i]", 0.0)                           /* a value that the last stage of a step left */       \
    LEAF(INERTIA, NULL, "", 0.0)                                /* of a degree of freedom at the start, likewise */    \
    LEAF(QUERY, NULL, "", 0.0)                                        /* a number that a formula asks for */       \
    LEAF(MASS, NULL, "", 1.0)                                   /* of a formula of effects, which takes its place */   \
    LEAF(DERIVATIVE, NULL, "dx[@X]", 0.0)                       /* where a derivative has been evaluated before */

/* Functions of the tick; constants as far as derivatives go. The value is by the same functions of core as the text,
 * with the same arguments.
 * TIMED(name, C text, how tightly it binds, value of the node `n` in the tick `tick`) */
#define ISOC_TIMED(TIMED)                                                                                              \
    /* an angle that grows by `value` turns a tick from `second` turns, in [-pi, pi) */                                \
    TIMED(PHASE, "iso_phase(tick, @v, @s)", WHOLE,                                                                     \
          iso_phase(tick, phase_of(n->value), phase_of(n->second)))                                                    \
    /* the ticks since tick `value`, limited to [0, second] */                                                         \
    TIMED(RAMP, "iso_ramp(tick, @w, @f, @2)", WHOLE,                                                                   \
          iso_ramp(tick, whole(n->value), fraction(n->value), n->second))                                              \
    /* Gaussian noise with the seed `value` */                                                                         \
    TIMED(NOISE, "iso_noise(tick, @w)", WHOLE,                                                                         \
          iso_noise(tick, whole(n->value)))                                                                            \
    /* seconds since tick 0; `second` in a tick */                                                                     \
    TIMED(TIME, "@2 * iso_real_of_ticks(tick)", PRODUCT,                                                               \
          n->second * iso_real_of_ticks(tick))                                                                         \
    /* 0 before tick `value`, 1 from it on */                                                                          \
    TIMED(FROM, "iso_from(tick, @w)", WHOLE,                                                                           \
          iso_from(tick, whole(n->value)))                                                                             \
    /* 1 in the first `index` ticks of a period of `value`, else -1; `second` ticks are over at tick 0 */              \
    TIMED(SQUARE, "iso_square(tick, @w, @W, @i)", WHOLE,                                                               \
          iso_square(tick, whole(n->value), whole(n->second), (uint32_t)n->index))                                     \
    /* the same, of a phase as that of PHASE */                                                                        \
    TIMED(SQUARE_OF_PHASE, "iso_square_of_phase(tick, @v, @s)", WHOLE,                                                 \
          iso_square_of_phase(tick, phase_of(n->value), phase_of(n->second)))                                          \
    /* the bits of a table, each for `value` ticks, `second` before they repeat */                                     \
    TIMED(PRBS, "iso_prbs(tick, prbs_@i, @w, @W)", WHOLE,                                                              \
          iso_prbs(tick, table_of(g, n)->words, whole(n->value), whole(n->second)))                                    \
    /* the angle of a sweep */                                                                                         \
    TIMED(CHIRP, "iso_chirp(tick, &chirp_@i)", WHOLE,                                                                  \
          value_of_chirp(table_of(g, n), tick))                                                                        \
    /* straight lines of a table */                                                                                    \
    TIMED(LINES, "iso_on_lines(tick, &lines_@i)", WHOLE,                                                               \
          value_of_lines(table_of(g, n), tick))                                                                        \
    /* the part of a period that is over, from 0 to 1: it grows by `value` in a tick, from `second` */                  \
    TIMED(CYCLE, "iso_cycle(tick, @v, @s)", WHOLE,                                                                     \
          iso_cycle(tick, phase_of(n->value), phase_of(n->second)))                                                    \
    /* the seconds since tick `value`, with `second` in a tick; before it, something less than zero */                 \
    TIMED(SINCE, "@2 * iso_since(tick, @w, @f)", PRODUCT,                                                              \
          n->second * iso_since(tick, whole(n->value), fraction(n->value)))

/* Operations on a and b, one of them or both; i is the node itself, da and db are the derivatives of the operands.
 * OPERATION(name, operands,
 *           value,
 *           derivative,
 *           the same on other operands,
 *           C text, its precedence, the least precedence of a and of b, its form,
 *           operations: add, mul, div, sincos) */
#define ISOC_OPERATIONS(OPERATION)                                                                                     \
    OPERATION(ADD, 2,                                                                                                  \
              a + b,                                                                                                   \
              add(g, da, db),                                                                                          \
              add(g, a, b),                                                                                            \
              "@a + @b", SUM, SUM, PRODUCT, DECLARED,                                                                  \
              1, 0, 0, 0)                                                                                              \
    OPERATION(SUB, 2,                                                                                                  \
              a - b,                                                                                                   \
              sub(g, da, db),                                                                                          \
              sub(g, a, b),                                                                                            \
              "@a - @b", SUM, SUM, PRODUCT, DECLARED,                                                                  \
              1, 0, 0, 0)                                                                                              \
    OPERATION(MUL, 2,                                                                                                  \
              a * b,                                                                                                   \
              sum_of_products(g, da, b, a, db),                                                                        \
              mul(g, a, b),                                                                                            \
              "@a * @b", PRODUCT, PRODUCT, WHOLE, DECLARED,                                                            \
              0, 1, 0, 0)                                                                                              \
    OPERATION(DIV, 2,                                                                                                  \
              a / b,                                                                                                   \
              derivative_of_quotient(g, i, b, da, db),                                                                 \
              divide(g, a, b),                                                                                         \
              "@a / @b", PRODUCT, PRODUCT, WHOLE, DECLARED,                                                            \
              0, 0, 1, 0)                                                                                              \
    OPERATION(NEG, 1,                                                                                                  \
              -a,                                                                                                      \
              neg(g, da),                                                                                              \
              neg(g, a),                                                                                               \
              "-@a", PRODUCT, WHOLE, WHOLE, INLINE,                                                                    \
              1, 0, 0, 0)                                                                                              \
    OPERATION(ABS, 1,                                                                                                  \
              fabs(a),                                                                                                 \
              derivative_of_magnitude(g, a, da),                                                                       \
              magnitude(g, a),                                                                                         \
              "iso_abs(@a)", WHOLE, SUM, SUM, DECLARED,                                                                \
              1, 0, 0, 0)                                                                                              \
    OPERATION(MAX, 2, /* the larger */                                                                                 \
              fmax(a, b),                                                                                              \
              derivative_of_chosen(g, a, b, da, db),                                                                   \
              larger(g, a, b),                                                                                         \
              "iso_max(@a, @b)", WHOLE, SUM, SUM, DECLARED,                                                            \
              1, 0, 0, 0)                                                                                              \
    OPERATION(ABOVE, 2, /* 1 if the first is the larger, else 0 */                                                     \
              iso_above(a, b),                                                                                         \
              constant(g, 0.0),                                                                                        \
              above(g, a, b),                                                                                          \
              "iso_above(@a, @b)", WHOLE, SUM, SUM, DECLARED,                                                          \
              1, 0, 0, 0)                                                                                              \
    OPERATION(WRAP, 1, /* an angle without its whole turns: within half a turn of zero */                              \
              iso_within_turn(a),                                                                                      \
              da,                                                                                                      \
              wrap(g, a),                                                                                              \
              "iso_within_turn(@a)", WHOLE, SUM, SUM, DECLARED,                                                        \
              5, 5, 0, 0)                                                                                              \
    OPERATION(CHANGE, 1, /* of its operand in a step; tools/isoc/plant/shares.c puts it there */                        \
              0.0,                                                                                                     \
              constant(g, 0.0),                                                                                        \
              function(g, OP_CHANGE, a, a),                                                                            \
              "", WHOLE, SUM, SUM, DECLARED,                                                                           \
              0, 0, 0, 0)                                                                                              \
    OPERATION(SIN, 1,                                                                                                  \
              iso_sincos(a).sin,                                                                                       \
              mul(g, cosine(g, a), da),                                                                                \
              sine(g, a),                                                                                              \
              "@t.sin", WHOLE, SUM, SUM, INLINE,                                                                       \
              0, 0, 0, 1)                                                                                              \
    OPERATION(COS, 1,                                                                                                  \
              iso_sincos(a).cos,                                                                                       \
              neg(g, mul(g, sine(g, a), da)),                                                                          \
              cosine(g, a),                                                                                            \
              "@t.cos", WHOLE, SUM, SUM, INLINE,                                                                       \
              0, 0, 0, 1)

/* Functions of core/numbers/HEADER.h; the code calls iso_WORD of the operands. In a corner the derivative is that of
 * one side: of min and max that of either, of sign, floor, round and a comparison 0. A root counts as a division.
 * Those of one header stand together.
 * FUNCTION(name, word, header, operands,
 *          value,
 *          derivative,
 *          operations in float: add, mul, div) */
#define ISOC_FUNCTIONS(FUNCTION)                                                                                       \
    FUNCTION(MIN, min, real, 2,                                                                                        \
             iso_min(a, b),                                                                                            \
             derivative_of_chosen(g, b, a, da, db),                                                                    \
             1, 0, 0)                                                                                                  \
    FUNCTION(POSITIVE, positive, real, 1, /* max(a, 0) */                                                              \
             iso_positive(a),                                                                                          \
             mul(g, above(g, a, constant(g, 0.0)), da),                                                                \
             1, 0, 0)                                                                                                  \
    FUNCTION(NEGATIVE, negative, real, 1, /* min(a, 0) */                                                              \
             iso_negative(a),                                                                                          \
             mul(g, above(g, constant(g, 0.0), a), da),                                                                \
             1, 0, 0)                                                                                                  \
    FUNCTION(SQRT, sqrt, sqrt, 1,                                                                                      \
             iso_sqrt(a),                                                                                              \
             divide(g, mul(g, constant(g, 0.5), da), i),                                                               \
             0, 0, 1)                                                                                                  \
    FUNCTION(INVERSE_ROOT, inverse_root, root, 1, /* 1 / sqrt(a) */                                                    \
             iso_inverse_root(a),                                                                                      \
             derivative_of_inverse_root(g, i, da),                                                                     \
             1, 0, 2)                                                                                                 \
    FUNCTION(EXP, exp, exp, 1,                                                                                         \
             value_of_exponential(a),                                                                                  \
             mul(g, i, da),                                                                                            \
             15, 9, 0)                                                                                                 \
    FUNCTION(LOG, log, log, 1,                                                                                         \
             value_of_logarithm(a),                                                                                    \
             divide(g, da, a),                                                                                         \
             23, 8, 1)                                                                                                 \
    FUNCTION(POWER, power, power, 2, /* a to the power b */                                                            \
             value_of_power_of(a, b),                                                                                  \
             derivative_of_power(g, i, a, b, da, db),                                                                  \
             43, 18, 1)                                                                                                \
    FUNCTION(TANH, tanh, tanh, 1,                                                                                      \
             iso_tanh(a),                                                                                              \
             mul(g, sub(g, constant(g, 1.0), mul(g, i, i)), da),                                                       \
             10, 8, 2)                                                                                                 \
    FUNCTION(ATAN2, atan2, angle, 2,                                                                                   \
             value_of_angle(a, b),                                                                                     \
             derivative_of_angle(g, a, b, da, db),                                                                     \
             41, 7, 1)                                                                                                 \
    FUNCTION(SIGN, sign, pieces, 1,                                                                                    \
             iso_sign(a),                                                                                              \
             constant(g, 0.0),                                                                                         \
             5, 0, 0)                                                                                                  \
    FUNCTION(FLOOR, floor, pieces, 1,                                                                                  \
             iso_floor(a),                                                                                             \
             constant(g, 0.0),                                                                                         \
             17, 0, 0)                                                                                                 \
    FUNCTION(ROUND, round, pieces, 1,                                                                                  \
             iso_round(a),                                                                                             \
             constant(g, 0.0),                                                                                         \
             7, 0, 0)                                                                                                  \
    FUNCTION(WHERE, where, pieces, 2, /* b where a is 1, 0 where a is 0 */                                             \
             iso_where(a, b),                                                                                          \
             function(g, OP_WHERE, a, db),                                                                             \
             3, 0, 0)                                                                                                  \
    FUNCTION(ONLY, only, pieces, 2, /* b where a is 1, else no number */                                               \
             iso_only(a, b),                                                                                           \
             function(g, OP_ONLY, a, db),                                                                              \
             3, 0, 0)                                                                                                  \
    FUNCTION(UNLESS, unless, pieces, 2, /* b where a is 0, 0 where a is 1 */                                           \
             iso_unless(a, b),                                                                                         \
             function(g, OP_UNLESS, a, db),                                                                            \
             3, 0, 0)
/* clang-format on */

#define ISOC_ENUMERATOR(NAME, ...) OP_##NAME,
typedef enum operation {
    ISOC_LEAVES(ISOC_ENUMERATOR) ISOC_TIMED(ISOC_ENUMERATOR) ISOC_OPERATIONS(ISOC_ENUMERATOR)
        ISOC_FUNCTIONS(ISOC_ENUMERATOR) OPERATIONS
} operation;
#undef ISOC_ENUMERATOR

typedef enum operator_kind { KIND_LEAF, KIND_TIMED, KIND_OPERATION } operator_kind;

/* A row. Members that only operations have are zero for leaves. */
typedef struct operator_row {
    operator_kind kind;
    int operands;
    const char *name, *array, *text;
    const char *call, *header; /* of a function of core: iso_exp( and the file that has it */
    binding binds, least_a, least_b;
    writing_form form;
    operations cost;
    double (*value)(const struct graph *g, const struct graph_node *n, const evaluation *at, double a, double b);
} operator_row;

extern const operator_row operators[OPERATIONS];

#endif
