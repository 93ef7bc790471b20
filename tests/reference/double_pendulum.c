#include "tests/reference/double_pendulum.h"

/* The plant's elbow is relative to its upper arm. */
static void to_plant(long double *const x, const long double *const y)
{
    x[0] = y[0];
    x[1] = y[1] - y[0];
    x[2] = y[2];
    x[3] = y[3] - y[2];
}

const reference_set the_reference = {
    .states = 4,
    .cases = sizeof double_pendulum_cases / sizeof *double_pendulum_cases,
    .first = double_pendulum_cases,
    .to_plant = to_plant,
};
