/* The recipes of euler in methods/method.c. */
#include "core/methods/euler.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_EULER, euler)
#include "tests/core/methods/method/run.h"

FIXED(euler, ISO_EULER)
FIXED(euler_both, ISO_EULER | BOTH)
