/* A planar chain of two uniform rods by hand, as tools/build/chain.sh describes it: absolute angles th1, th2 = th1 + q2,
 * and s, c of q2. With rods of mass and length 1 and k = 1/2, b = J + 1/4, J the moment about the centre:
 *
 * (b + 1) a1 + k c a2 = k s w2^2 - 3/2 g sin th1,  k c a1 + b a2 = -k s w1^2 - 1/2 g sin th2.
 *
 * The second row, divided by b, goes into the first; sin th2 comes from the sines and cosines at hand.
 */
#include "core/sincos.h"
#include "tests/handwritten/plant.h"

#define B (R(1.0) / R(12.0) + R(0.25e-4) + R(0.25))
#define HALF_G R(4.905)

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
    const real kc = R(0.5) * second.cos;
    const real ks = R(0.5) * second.sin;
    const real g1 = HALF_G * first.sin;
    const real g2 = g1 * second.cos + (HALF_G * first.cos) * second.sin;

    const real r1 = ks * (w2 * w2) - R(3.0) * g1;
    const real minus_r2 = ks * (w1 * w1) + g2;
    const real l = (R(1.0) / B) * kc;
    const real a1 = (r1 + l * minus_r2) / ((B + R(1.0)) - l * kc);
    const real minus_a2 = (R(1.0) / B) * minus_r2 + l * a1;

    dx[0] = w1;
    dx[1] = x[3];
    dx[2] = a1;
    dx[3] = -minus_a2 - a1;
}

HANDWRITTEN_PLANT("chain_2", 4, 0, 0);
