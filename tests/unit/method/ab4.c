/* The recipes of ab4 in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_AB4)
#include "tests/unit/method/run.h"

FIXED(ab4, ISO_AB4)
FIXED(ab4_both, ISO_AB4 | BOTH)
