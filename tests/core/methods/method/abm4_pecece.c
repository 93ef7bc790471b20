/* The recipes of abm4_pecece in methods/method.c. */
#include "core/methods/abm4_pecece.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_ABM4_PECECE, abm4_pecece)
#include "tests/core/methods/method/run.h"

FIXED(abm4_pecece, ISO_ABM4_PECECE)
FIXED(abm4_pecece_both, ISO_ABM4_PECECE | BOTH)
