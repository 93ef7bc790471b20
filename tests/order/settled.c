/* PLANT names the source of the plant; SETTLE is NULL of one that puts nothing right after a step. */
#include "core/methods/method.h"

#include PLANT

#include "tests/order/settled.h"

#ifndef SETTLE
#define SETTLE settle
#endif

const iso_equations *const the_equations = &equations;
void (*const the_settle)(real *x) = SETTLE;
