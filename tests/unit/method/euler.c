/* The recipes of euler in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_EULER)
#include "tests/unit/method/run.h"

FIXED(euler, ISO_EULER)
FIXED(euler_both, ISO_EULER | BOTH)
