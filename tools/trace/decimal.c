#include "tools/trace/decimal.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

/* A decimal number of at most DBL_DIG digits survives the way through a double. So if there is one that reads back
 * as x, x printed with DBL_DIG digits is that one (%g drops zeros at the end); else every digit more is needed. */
const char *decimal_of_double(const double x, char text[DECIMAL_BYTES])
{
    int digits = DBL_DIG;
    do {
        snprintf(text, DECIMAL_BYTES, "%.*g", digits, x);
    } while (digits++ < DBL_DECIMAL_DIG && strtod(text, NULL) != x);
    return text;
}

const char *decimal_of_float(const float x, char text[DECIMAL_BYTES])
{
    int digits = FLT_DIG;
    do {
        snprintf(text, DECIMAL_BYTES, "%.*g", digits, (double)x);
    } while (digits++ < FLT_DECIMAL_DIG && strtof(text, NULL) != x);
    return text;
}
