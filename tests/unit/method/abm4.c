/* The recipes of abm4 in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_ABM4)
#include "tests/unit/method/run.h"

FIXED(abm4, ISO_ABM4)
FIXED(abm4_both, ISO_ABM4 | BOTH)
