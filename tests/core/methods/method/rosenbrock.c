/* The recipes of rosenbrock in methods/method.c. */
#include "core/methods/rosenbrock.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_ROSENBROCK, rosenbrock)
#include "tests/core/methods/method/run.h"

FIXED(rosenbrock, ISO_ROSENBROCK)
FIXED(rosenbrock_both, ISO_ROSENBROCK | BOTH)
