/* The recipes of rk4 in methods/method.c. */
#include "core/methods/rk4.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_RK4, rk4)
#include "tests/core/methods/method/run.h"

FIXED(rk4, ISO_RK4)
FIXED(rk4_both, ISO_RK4 | BOTH)
