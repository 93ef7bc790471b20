/* The recipes of abm4_pec in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_ABM4_PEC)
#include "tests/unit/method/run.h"

FIXED(abm4_pec, ISO_ABM4_PEC)
FIXED(abm4_pec_both, ISO_ABM4_PEC | BOTH)
