#include "tools/trace/decimal.h"

#include <float.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

/* A decimal number of at most DBL_DIG digits survives the way through a double. So if there is one that reads back
 * as x, x printed with DBL_DIG digits is that one (%g drops zeros at the end); else every digit more is needed. */
const char *decimal_of(const double x, const size_t bytes, char text[DECIMAL_BYTES])
{
    const bool is_float = bytes == sizeof(float);
    int digits = is_float ? FLT_DIG : DBL_DIG;
    const int most = is_float ? FLT_DECIMAL_DIG : DBL_DECIMAL_DIG;
    do {
        snprintf(text, DECIMAL_BYTES, "%.*g", digits, x);
    } while (digits++ < most && (is_float ? (double)strtof(text, NULL) : strtod(text, NULL)) != x);
    return text;
}
