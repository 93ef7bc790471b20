/* PLANT names the source of the plant. */
#include "core/methods/method.h"

#include PLANT

#include "tests/order/settled.h"

const iso_equations *const the_equations = &equations;
void (*const the_settle)(real *x) = settle;
