/* For tcc: it does not set errno for a root. Read first in what it compiles (`quick` of tests/host/test.sh). It
 * compiles some expressions in long double wrongly. With double as the name of a type long double is an error, but in
 * the headers that are read before.
 */
#include <math.h>
#include <stdlib.h>

#define __NO_MATH_ERRNO__ 1

typedef double tcc_double;
#define double tcc_double
