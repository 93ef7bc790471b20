/* The recipes of rosenbrock in unit/method.c. */
#define ISO_ONLY_METHODS (1 << ISO_ROSENBROCK)
#include "tests/unit/method/run.h"

FIXED(rosenbrock, ISO_ROSENBROCK)
FIXED(rosenbrock_both, ISO_ROSENBROCK | BOTH)
