/* From both arms horizontal, against the reference solution at 1 s. */
#include "tests/reference/double_pendulum.h"
#include "tests/core/methods/order/order.h"

static void exact(long double y[ORDER_STATES_MAX], const double *const defaults)
{
    (void)defaults;
    const long double *const absolute = double_pendulum_cases[0].row[0].y;
    y[0] = absolute[0];
    y[1] = absolute[1] - absolute[0];
    y[2] = absolute[2];
    y[3] = absolute[3] - absolute[2];
}

const order_problem the_problem = {
    .states = 4,
    .start = {1.57079632679489661923, 0.0, 0.0, 0.0},
    .exact = exact,
};
