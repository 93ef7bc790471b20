/* PLANT names the source of the plant; SETTLE is NULL of one that puts nothing right after a step, PIVOTS how many
 * pivots it tells there, if any. */
#include "core/methods/all.h"
#include "core/methods/method.h"

#include PLANT

#include "tests/core/methods/order/settled.h"

#ifdef PIVOTS
static void settle_alone(real *const x)
{
    real pivots[PIVOTS];
    settle(x, pivots);
}
#define SETTLE settle_alone
#endif

#ifndef SETTLE
#define SETTLE settle
#endif

const iso_equations *const the_equations = &equations;
void (*const the_settle)(real *x) = SETTLE;
