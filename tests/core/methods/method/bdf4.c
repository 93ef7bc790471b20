/* The recipes of bdf4 in methods/method.c. */
#include "core/methods/bdf4.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_BDF4, bdf4)
#include "tests/core/methods/method/run.h"

FIXED(bdf4, ISO_BDF4)
FIXED(bdf4_once, ISO_BDF4 | ISO_ITERATIONS(1))
FIXED(bdf4_both, ISO_BDF4 | BOTH | ISO_ITERATIONS(3))
