/* The recipes of bdf4 in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_BDF4)
#include "tests/unit/method/run.h"

FIXED(bdf4, ISO_BDF4)
FIXED(bdf4_once, ISO_BDF4 | ISO_ITERATIONS(1))
FIXED(bdf4_both, ISO_BDF4 | BOTH | ISO_ITERATIONS(3))
