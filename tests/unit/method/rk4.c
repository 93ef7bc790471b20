/* The recipes of rk4 in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_RK4)
#include "tests/unit/method/run.h"

FIXED(rk4, ISO_RK4)
FIXED(rk4_both, ISO_RK4 | BOTH)
