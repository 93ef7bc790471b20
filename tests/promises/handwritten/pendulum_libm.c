/* The pendulum with the C library's sine, whose time depends on its argument: what the count of a step must notice. */
#include <math.h>

#include "tests/promises/handwritten/plant.h"

static const real start[2] = {R(1.5707963267948966), R(0.0)};
static const real defaults[1] = {R(0.0)};

static inline void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                              const real *restrict const p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = R(-9.81) * sin(x[0]);
}

HANDWRITTEN_PLANT("pendulum_libm", 2, 0, 0);
