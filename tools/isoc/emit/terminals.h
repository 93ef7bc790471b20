/* Inputs, outputs and tunables of a plant as a controller at the other end of a wire sees them, and a program of
 * another language that has the plant in it. */
#ifndef ISOC_EMIT_TERMINALS_H
#define ISOC_EMIT_TERMINALS_H

#include "tools/isoc/emit/parts.h"

/* The inputs are those that come in from outside: the wires. */
typedef struct terminals {
    const char *prefix, *capitals; /* of names in C: cart_pole, CART_POLE */
    const char *scene;
    const variable *inputs, *outputs, *tunables;
    int input_count, output_count, tunable_count;
    uint64_t identity;
    long period_ns;
    bool is_double;
} terminals;

/* The identity of the plant follows from its header and its source, the first two of the files, and from its wires. */
terminals terminals_of(const plant *p, const naming *names, const file_list *files);

/* The wires as C: the inputs that come over the link, with their safe values. */
void emit_wires(const plant *p, const naming *names, text *out);

/* The identity as C and Python have it; and a number of a range, of which none is `infinity`. */
const char *identity_of(const terminals *t, arena *memory);
const char *bound(arena *memory, double number, const char *infinity);

/* python.c: adds the controller's end in Python, a module that is a package too. */
void add_python_of_link(const terminals *t, file_list *files);

#endif
