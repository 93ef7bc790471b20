/* A plant whose equations are in reach of the test: PLANT names its source. */
#include "core/methods/all.h"
#include "core/methods/method.h"

#ifndef PLANT
#define PLANT "models/oscillator.c"
#endif
#include PLANT

#include "tests/core/methods/order/order.h"

const iso_equations *const the_equations = &equations;
