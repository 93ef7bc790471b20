/* The recipes of semi_implicit in methods/method.c. */
#include "core/methods/semi_implicit.h"
#define ISO_METHOD_LIST(X, r) X(r, ISO_SEMI_IMPLICIT, semi_implicit)
#include "tests/core/methods/method/run.h"

FIXED(semi_implicit, ISO_SEMI_IMPLICIT)
FIXED(semi_implicit_both, ISO_SEMI_IMPLICIT | BOTH)
