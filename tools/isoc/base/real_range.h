/* The numbers that the plant's type holds: zero, and the normal finite numbers. */
#ifndef ISOC_BASE_REAL_RANGE_H
#define ISOC_BASE_REAL_RANGE_H

#include <stdbool.h>

bool real_holds(double number, bool is_double);

/* Whether it is less than the least normal float, but not zero: a float takes it as a factor, scaled by powers of two.
 */
bool real_is_tiny(double number, bool is_double);

/* The advice for a number that the type does not hold: the range, and a remedy. */
const char *real_advice(double number, bool is_double);

#endif
