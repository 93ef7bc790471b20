/* A planar chain of three uniform rods by hand, as tools/lab/chain.py describes it: absolute angles th_i. With rods
 * of mass and length 1, J the moment about the centre, B = 2 (J + 1/4) and s_ij, c_ij of th_j - th_i, twice the
 * equations of Lagrange are
 *
 * sum_j M_ij a_j = r_i,  M_ii = B + 2 (3 - i),  M_ij = k_j c_ij with k_2 = 3, k_3 = 1 for i < j,
 * r_i = sum over j > i of k_j s_ij w_j^2 - sum over j < i of k_i s_ji w_j^2 - (7 - 2 i) g sin th_i.
 *
 * What is summed over j < i, with g sin th_i, is k_i times what accelerates joint i across rod i; what is summed over
 * j > i is f_i, the force that the rods beyond put on rod i across it. Eliminated from the last row to the first, the
 * second and the first row times B.
 */
#include "core/numbers/sincos.h"
#include "tests/promises/handwritten/plant.h"

#define B (R(2.0) * (R(1.0) / R(12.0) + R(0.25e-4) + R(0.25)))
#define G R(9.81)

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
    const real square_2 = w2 * w2;
    const real square_3 = w3 * w3;

    const real across_1 = G * one.sin;
    const real along_1 = G * one.cos + w1 * w1;
    const real across_2 = two.cos * across_1 + two.sin * along_1;
    const real along_2 = two.cos * along_1 - two.sin * across_1 + square_2;
    const real across_3 = three.cos * across_2 + three.sin * along_2;
    const real f2 = three.sin * square_3;
    const real f1 = two.cos * f2 + two.sin * (R(3.0) * square_2 + three.cos * square_3);
    const real r1 = f1 - R(5.0) * across_1;
    const real r2 = f2 - R(3.0) * across_2;

    const real c13 = two.cos * three.cos - two.sin * three.sin;
    const real d11 = B * (B + R(4.0)) - c13 * c13;
    const real d12 = (R(3.0) * B) * two.cos - three.cos * c13;
    const real d22 = B * (B + R(2.0)) - three.cos * three.cos;
    const real e1 = B * r1 + c13 * across_3;
    const real e2 = B * r2 + three.cos * across_3;
    const real inverse = R(1.0) / d22;
    const real l21 = d12 * inverse;

    const real a1 = (e1 - l21 * e2) / (d11 - l21 * d12);
    const real a2 = inverse * e2 - l21 * a1;
    const real a3 = -(R(1.0) / B) * (across_3 + c13 * a1 + three.cos * a2);

    dx[0] = w1;
    dx[1] = x[4];
    dx[2] = x[5];
    dx[3] = a1;
    dx[4] = a2 - a1;
    dx[5] = a3 - a2;
}

HANDWRITTEN_PLANT("chain_3", 6, 0, 0);
