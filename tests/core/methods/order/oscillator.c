/* m x'' = F - c x' - k x with a constant force from rest at 0.1 m: with g = c / 2m, w^2 = k / m - g^2, s = F / k,
 * x = s + exp(-g t) ((0.1 - s) cos w t + g (0.1 - s) / w sin w t). */
#include <math.h>

#include "tests/core/methods/order/order.h"

#define START 0.1
#define FORCE 1.0

enum { MASS, DAMPING, STIFFNESS };

static void exact(long double y[ORDER_STATES_MAX], const double *const defaults)
{
    const long double m = (long double)defaults[MASS];
    const long double k = (long double)defaults[STIFFNESS];
    const long double g = (long double)defaults[DAMPING] / (2.0L * m);
    const long double w = sqrtl(k / m - g * g);
    const long double away = (long double)START - (long double)FORCE / k;
    const long double fade = expl(-g);
    y[0] = (long double)FORCE / k + fade * away * (cosl(w) + g / w * sinl(w));
    y[1] = -fade * away * (w + g * g / w) * sinl(w);
}

const order_problem the_problem = {
    .states = 2,
    .start = {START, 0.0},
    .input = {FORCE},
    .exact = exact,
};
