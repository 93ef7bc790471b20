/* A planar chain of three uniform rods by hand, as tools/build/chain.sh describes it: absolute angles th_i. With rods of
 * mass and length 1, J the moment about the centre and s_ij, c_ij of th_j - th_i:
 *
 * sum_j M_ij a_j = r_i,  M_ii = J + 1/4 + 3 - i,  M_ij = k_j c_ij with k_2 = 3/2, k_3 = 1/2 for i < j,
 * r_i = sum over j > i of k_j s_ij w_j^2 - sum over j < i of k_i s_ji w_j^2 - (7/2 - i) g sin th_i.
 *
 * Eliminated from the last row to the first; sines and cosines of sums come from those at hand.
 */
#include "core/sincos.h"
#include "tests/handwritten/plant.h"

#define M_33 (R(1.0) / R(12.0) + R(0.25e-4) + R(0.25))
#define HALF_G R(4.905)

static const real start[6] = {R(1.5707963267948966), R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)};
static const real defaults[1] = {R(0.0)};

static inline void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                              const real *restrict const p)
{
    (void)u;
    (void)p;
    const iso_sine_cosine one = iso_sincos(x[0]);
    const iso_sine_cosine two = iso_sincos(x[1]);
    const iso_sine_cosine three = iso_sincos(x[2]);
    const real w1 = x[3];
    const real w2 = x[3] + x[4];
    const real w3 = w2 + x[5];
    const real square_1 = w1 * w1;
    const real square_2 = w2 * w2;
    const real square_3 = w3 * w3;

    const real m23 = R(0.5) * three.cos;
    const real n23 = R(0.5) * three.sin;
    const real m12 = R(1.5) * two.cos;
    const real n12 = R(1.5) * two.sin;
    const real m13 = two.cos * m23 - two.sin * n23;
    const real n13 = two.sin * m23 + two.cos * n23;
    const real g1_sin = HALF_G * one.sin;
    const real g1_cos = HALF_G * one.cos;
    const real g2_sin = g1_sin * two.cos + g1_cos * two.sin;
    const real g2_cos = g1_cos * two.cos - g1_sin * two.sin;
    const real g3_sin = g2_sin * three.cos + g2_cos * three.sin;

    const real r1 = n12 * square_2 + n13 * square_3 - R(5.0) * g1_sin;
    const real r2 = n23 * square_3 - n12 * square_1 - R(3.0) * g2_sin;
    const real minus_r3 = n13 * square_1 + n23 * square_2 + g3_sin;

    const real l31 = (R(1.0) / M_33) * m13;
    const real l32 = (R(1.0) / M_33) * m23;
    const real d11 = (M_33 + R(2.0)) - l31 * m13;
    const real d12 = m12 - l32 * m13;
    const real d22 = (M_33 + R(1.0)) - l32 * m23;
    const real e1 = r1 + l31 * minus_r3;
    const real e2 = r2 + l32 * minus_r3;
    const real inverse = R(1.0) / d22;
    const real l21 = d12 * inverse;

    const real a1 = (e1 - l21 * e2) / (d11 - l21 * d12);
    const real a2 = inverse * e2 - l21 * a1;
    const real minus_a3 = (R(1.0) / M_33) * minus_r3 + l31 * a1 + l32 * a2;

    dx[0] = w1;
    dx[1] = x[4];
    dx[2] = x[5];
    dx[3] = a1;
    dx[4] = a2 - a1;
    dx[5] = -minus_a3 - a2;
}

HANDWRITTEN_PLANT("chain_3", 6, 0, 0);
