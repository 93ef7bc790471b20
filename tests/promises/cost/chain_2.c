/* A planar chain of two uniform rods by hand, as tools/lab/chain.py describes it: absolute angles th1, th2 = th1 +
 * q2, and s, c of q2. With rods of mass and length 1, J the moment about the centre and B = 2 (J + 1/4), twice the
 * equations of Lagrange are
 *
 * (B + 2) a1 + c a2 = s w2^2 - 3 g sin th1,  c a1 + B a2 = -(s w1^2 + g sin th2).
 *
 * a2 of the second goes into the first, times B; sin th2 comes from the sines and cosines at hand.
 */
#include "core/numbers/sincos.h"
#include "tests/promises/handwritten/plant.h"

#define B (R(2.0) * (R(1.0) / R(12.0) + R(0.25e-4) + R(0.25)))
#define G R(9.81)

static const real start[4] = {R(1.5707963267948966), R(0.0), R(0.0), R(0.0)};
static const real defaults[1] = {R(0.0)};

static inline void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                              const real *restrict const p)
{
    (void)u;
    (void)p;
    const iso_sine_cosine first = iso_sincos(x[0]);
    const iso_sine_cosine second = iso_sincos(x[1]);
    const real w1 = x[2];
    const real w2 = x[2] + x[3];
    const real s = second.sin;
    const real c = second.cos;
    const real g1_sin = G * first.sin;

    const real r1 = s * (w2 * w2) - R(3.0) * g1_sin;
    const real minus_r2 = s * (w1 * w1 + G * first.cos) + c * g1_sin;
    const real a1 = (B * r1 + c * minus_r2) / (B * (B + R(2.0)) - c * c);
    const real a2 = -(R(1.0) / B) * (minus_r2 + c * a1);

    dx[0] = w1;
    dx[1] = x[3];
    dx[2] = a1;
    dx[3] = a2 - a1;
}

HANDWRITTEN_PLANT("chain_2", 4, 0, 0);
