/* The recipes of abm4 in methods/method.c. */
#include "core/methods/abm4.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_ABM4, abm4)
#include "tests/core/methods/method/run.h"

FIXED(abm4, ISO_ABM4)
FIXED(abm4_both, ISO_ABM4 | BOTH)
