/* The recipes of abm4_pecece in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_ABM4_PECECE)
#include "tests/unit/method/run.h"

FIXED(abm4_pecece, ISO_ABM4_PECECE)
FIXED(abm4_pecece_both, ISO_ABM4_PECECE | BOTH)
