/* A plant with what it puts right after a step in reach of the test. */
#ifndef ISO_TESTS_ORDER_SETTLED_H
#define ISO_TESTS_ORDER_SETTLED_H

#include <stdbool.h>

#include "core/methods/all.h"
#include "core/methods/primed.h"
#include "core/runtime/plant.h"

extern const iso_equations *const the_equations; /* with their Jacobian */
extern void (*const the_settle)(real *x);

#endif
