/* models/cart_pole.scene by hand: cart of 1 kg, uniform rod of mass m and half length l, both tunable.
 *
 * (1 + m) x'' + m l cos th'' = F - d x' + m l sin th'^2
 * m l cos x'' + 4/3 m l^2 th'' = m l g sin - e th'
 * Cramer's rule with one reciprocal; the parameters may change between steps, so nothing of them is kept.
 */
#include "core/numbers/sincos.h"
#include "tests/promises/handwritten/plant.h"

enum { ROD_MASS, HALF_LENGTH, RAIL_DAMPING, PARAMETERS };

static const real start[4] = {R(0.0), R(0.087266462599716474), R(0.0), R(0.0)};
static const real defaults[PARAMETERS] = {R(0.2), R(0.25), R(0.1)};

static inline void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                              const real *restrict const p)
{
    const iso_sine_cosine th = iso_sincos(x[1]);
    const real ml = p[ROD_MASS] * p[HALF_LENGTH];
    const real coupling = ml * th.cos;
    const real inertia = (ml * p[HALF_LENGTH]) * R(1.3333333333333333);
    const real mass = R(1.0) + p[ROD_MASS];

    const real lift = ml * th.sin;
    const real force = (u[0] - p[RAIL_DAMPING] * x[2]) + lift * (x[3] * x[3]);
    const real torque = R(9.81) * lift - R(0.002) * x[3];
    const real inverse = R(1.0) / (mass * inertia - coupling * coupling);

    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = (inertia * force - coupling * torque) * inverse;
    dx[3] = (mass * torque - coupling * force) * inverse;
}

HANDWRITTEN_PLANT("cart_pole", 4, 1, PARAMETERS);
