/* The recipes of heun in methods/method.c. */
#include "core/methods/heun.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_HEUN, heun)
#include "tests/core/methods/method/run.h"

FIXED(heun, ISO_HEUN)
FIXED(heun_both, ISO_HEUN | BOTH)
