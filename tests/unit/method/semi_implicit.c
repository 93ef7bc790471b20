/* The recipes of semi_implicit in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_SEMI_IMPLICIT)
#include "tests/unit/method/run.h"

FIXED(semi_implicit, ISO_SEMI_IMPLICIT)
FIXED(semi_implicit_both, ISO_SEMI_IMPLICIT | BOTH)
