/* Functions in formulas: sqrt(2), atan2(3 mm, 4 mm), sin(30 deg), and those of time. A new one is a row of the table
 * and a function that makes its nodes. */
#ifndef ISOC_FORMULA_FUNCTIONS_H
#define ISOC_FORMULA_FUNCTIONS_H

#include "tools/isoc/formula/value.h"

enum { MOST_ARGUMENTS = 64 };

typedef enum function_kind {
    OF_VALUES, /* of its arguments alone */
    OF_TIME,   /* of the tick too: in formulas that are not of an input, an input of its own */
    OF_JUMPS,  /* such a one that jumps, at each of which a method with a history starts again */
    OF_POINTS, /* of the tick, or of its arguments, by points */
    OF_PAST,   /* of its first argument in rows before, or in a whole step: a memory has its value */
} function_kind;

/* How a memory follows its formula `next`. A memory of an effect takes the value of `next`. A memory of a formula takes
 * its value in every row whose number is a multiple of some ticks (sample), or the value of so many ticks ago; that of
 * a share is found at the begin of each step. */
typedef enum keeping { KEPT_NEXT, KEPT_SAMPLE, KEPT_SHARE, KEPT_PREVIOUS, KEPT_DELAY } keeping;

/* The value of a call for arguments that are numbers. A problem of its own is noted at the call. */
typedef value function_call(values *v, const formula *f, const value *arguments);

/* A function, with the number and the kind of its arguments. */
typedef struct function_row {
    const char *name, *example; /* NULL: points have no number of arguments */
    size_t least, most;         /* arguments */
    int parts;                  /* of each: 1, or those of a vector */
    function_call *call;        /* NULL: its arguments are not evaluated before */
    function_kind kind;
    keeping kept; /* of OF_PAST */
} function_row;

/* The function of a call; NULL after noting a problem. */
const function_row *find_function(values *v, const formula *f);

/* The function with this word; NULL where there is none. */
const function_row *function_called(const char *word);

/* power.c: a value to a power: a whole number or a half of one of any value, and any plain number of a plain number. */
value power_of(values *v, const formula *f, const value *base, const value *exponent);

/* The value of a comparison of two values: 1 or 0. */
value order_of(values *v, const formula *f, const value *arguments);

#endif
