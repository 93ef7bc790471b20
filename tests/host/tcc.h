/* What the other compilers have built in, for tcc; read first in what it compiles (`quick` of tests/host/test.sh). It
 * compiles some expressions in long double wrongly. With double as the name of a type long double is an error.
 */
#include <math.h>
#include <stdlib.h>

#define __NO_MATH_ERRNO__ 1
#define __builtin_sqrt sqrt
#define __builtin_sqrtf sqrtf
#define __builtin_trap abort

typedef double tcc_double;
#define double tcc_double
