/* The recipes of heun in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_HEUN)
#include "tests/unit/method/run.h"

FIXED(heun, ISO_HEUN)
FIXED(heun_both, ISO_HEUN | BOTH)
