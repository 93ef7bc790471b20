/* Functions in formulas: sqrt(2), atan2(3 mm, 4 mm), sin(30 deg), and those of time. A new one is a row of the table and a
 * function that makes its nodes. */
#ifndef ISOC_FORMULA_FUNCTIONS_H
#define ISOC_FORMULA_FUNCTIONS_H

#include "tools/isoc/formula/value.h"

enum { MOST_ARGUMENTS = 64 };

/* A function: what it takes, and its value for arguments that are numbers. A problem of its own is noted at the call. NULL:
 * its arguments are not evaluated before. */
typedef struct function_row {
    const char *name, *example;
    size_t least, most; /* arguments */
    int parts;          /* of each: 1, or those of a vector */
    value (*call)(values *v, const formula *f, const value *given);
} function_row;

/* That of a call; NULL after noting a problem. */
const function_row *find_function(values *v, const formula *f);

/* Of a comparison of two values: 1 or 0. */
value order_of(values *v, const formula *f, const value *given);

#endif
