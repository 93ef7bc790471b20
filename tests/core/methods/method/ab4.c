/* The recipes of ab4 in methods/method.c. */
#include "core/methods/ab4.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_AB4, ab4)
#include "tests/core/methods/method/run.h"

FIXED(ab4, ISO_AB4)
FIXED(ab4_both, ISO_AB4 | BOTH)
