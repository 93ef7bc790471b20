#include "tests/reference/pendulum.h"

static void to_plant(long double *const x, const long double *const y)
{
    x[0] = y[0];
    x[1] = y[1];
}

const reference_set the_reference = {
    .states = 2,
    .cases = sizeof pendulum_cases / sizeof *pendulum_cases,
    .first = pendulum_cases,
    .to_plant = to_plant,
};
