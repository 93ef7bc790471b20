/* The recipes of abm4_pec in methods/method.c. */
#include "core/methods/abm4_pec.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_ABM4_PEC, abm4_pec)
#include "tests/core/methods/method/run.h"

FIXED(abm4_pec, ISO_ABM4_PEC)
FIXED(abm4_pec_both, ISO_ABM4_PEC | BOTH)
