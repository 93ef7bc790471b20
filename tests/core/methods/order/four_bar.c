/* A closed loop: crank upright, coupler on a triangle 5-12-13, rocker on one 3-4-5. The solution is rk4's with 2^-16 s
 * and compensated sums, a quarter of the test's finest step. */
#include <math.h>
#include <string.h>

#include "core/methods/all.h"
#include "core/methods/method.h"
#include "tests/core/methods/order/order.h"

enum { STATES = 6, FINEST = 16 };

static void exact(long double y[ORDER_STATES_MAX], const double *const defaults)
{
    static double x[STATES * 2];
    static bool known;
    double work[ISO_PRIME_VECTORS * STATES];
    iso_progress progress = {.local_error = 0.0};
    if (!known) {
        memcpy(x, the_problem.start, STATES * sizeof *x);
        for (long step = 0; step < 1L << FINEST; step++) {
            iso_method_step(ISO_RK4 | ISO_COMPENSATED, STATES, the_equations, ldexp(1.0, -FINEST), x, NULL, defaults,
                            NULL, work, &progress);
        }
        known = true;
    }
    for (int i = 0; i < STATES; i++) {
        y[i] = (long double)x[i];
    }
}

const order_problem the_problem = {
    .states = STATES,
    .start = {1.57079632679489661923, -1.17600520709513510249, 2.21429743558818100604, 1.05, -1.3, 0.4},
    .exact = exact,
};
