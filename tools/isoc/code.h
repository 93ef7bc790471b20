/* From nodes to straight-line C: one `const real` per quantity that has a name or more than one use, in the order in
 * which the equations were written, under their headings. */
#ifndef ISOC_CODE_H
#define ISOC_CODE_H

#include "tools/isoc/graph.h"

/* Text that grows. */
typedef struct text {
    arena *memory;
    char *bytes;
    size_t length, room;
} text;

void text_add(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

typedef struct operations {
    int add, mul, div, sincos; /* comparisons and signs count as additions */
} operations;

/* How leaves are called in the code. */
typedef struct leaf_names {
    const char *const *states, *const *inputs, *const *parameters;
} leaf_names;

/* One function's worth of statements: `targets[i] = roots[i]`. */
typedef struct code {
    graph *g;
    leaf_names names;
    bool is_double;
    const char *const *targets;
    const node *roots;
    size_t count;
} code;

/* Adds the statements, indented by four spaces. Returns false if a constant leaves the range of real; *culprit is it. */
bool code_emit(const code *c, text *out, double *culprit);

/* What the statements compute. */
operations code_count(const graph *g, const node *roots, size_t count);

/* Cycles of a Cortex-M4F, but for sines and cosines, which every way to the same equations shares. */
int code_price(operations n);

/* The shortest decimal that reads back as the same real, e.g. R(0.1). */
const char *code_literal(arena *memory, double value, bool is_double);

/* Whether any node of this operation is needed for the roots. */
bool code_uses(const graph *g, const node *roots, size_t count, operation op);

#endif
