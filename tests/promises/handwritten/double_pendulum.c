/* models/double_pendulum.scene by hand: unit masses and rods, absolute angles th1, th2 = th1 + elbow inside.
 *
 * 2 a1 + c a2 = s w2^2 - 2 g sin th1;  c a1 + a2 = -s w1^2 - g sin th2;  s, c of the elbow.
 * The second row, a2 = r2 - c a1, put into the first leaves one division; sin th2 comes from the sines and
 * cosines at hand.
 */
#include "core/numbers/sincos.h"
#include "tests/promises/handwritten/plant.h"

static const real start[4] = {R(1.5707963267948966), R(0.0), R(0.0), R(0.0)};
static const real defaults[1] = {R(0.0)};

static inline void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                              const real *restrict const p)
{
    (void)u;
    (void)p;
    const iso_sine_cosine shoulder = iso_sincos(x[0]);
    const iso_sine_cosine elbow = iso_sincos(x[1]);
    const real w1 = x[2];
    const real w2 = x[2] + x[3];
    const real g1 = R(-9.81) * shoulder.sin;
    const real g2 = g1 * elbow.cos + (R(-9.81) * shoulder.cos) * elbow.sin;

    const real r1 = elbow.sin * (w2 * w2) + (g1 + g1);
    const real r2 = g2 - elbow.sin * (w1 * w1);
    const real a1 = (r1 - elbow.cos * r2) / (R(2.0) - elbow.cos * elbow.cos);
    const real a2 = r2 - elbow.cos * a1;

    dx[0] = x[2];
    dx[1] = x[3];
    dx[2] = a1;
    dx[3] = a2 - a1;
}

HANDWRITTEN_PLANT("double_pendulum", 4, 0, 0);
