/* Sine and cosine without a branch, in + - * and the bits of the result.
 *
 * Domain |x| <= 1e4, error of each at most 1.5 ulp of 1.0 there (tests/exhaustive/sincos.c). Outside of the domain the
 * result is meaningless; for an infinity or a NaN it is NaN. sin(-x) = -sin(x), cos(-x) = cos(x) exactly.
 *
 * Reduction: Cody and Waite (1980), Software Manual for the Elementary Functions, ch. 8: pi/2 in two parts of a double
 * or three of a float, all but the last short enough for k times them to be exact. Polynomials on [-pi/4, pi/4]: float
 * from Moshier's Cephes (1989), sinf.c; double from Sun's fdlibm (1993), k_sin.c and k_cos.c.
 */
#ifndef ISO_CORE_NUMBERS_SINCOS_H
#define ISO_CORE_NUMBERS_SINCOS_H

#include "core/numbers/real.h"

typedef struct iso_sine_cosine {
    real sin;
    real cos;
} iso_sine_cosine;

#ifdef ISO_REAL_DOUBLE

/* The parts of pi/2. */
#define ISO_QUARTER_1 R(1.57079632673412561417e+00)
#define ISO_QUARTER_2 R(6.07710050650619224932e-11)

/* x - k pi/2 for a whole number |k| <= 6400 near x / (pi/2). */
static inline real iso_less_quarters(const real x, const real k)
{
    return (x - k * ISO_QUARTER_1) - k * ISO_QUARTER_2;
}

/* (sin(r) - r) / r^3 of z = r^2. */
static inline real iso_sine_tail(const real z)
{
    real s = R(1.58969099521155010221e-10);
    s = s * z - R(2.50507602534068634195e-08);
    s = s * z + R(2.75573137070700676789e-06);
    s = s * z - R(1.98412698298579493134e-04);
    s = s * z + R(8.33333333332248946124e-03);
    return s * z - R(1.66666666666666324348e-01);
}

/* (cos(r) - 1 + z / 2) / z^2 of z = r^2. */
static inline real iso_cosine_tail(const real z)
{
    real c = -R(1.13596475577881948265e-11);
    c = c * z + R(2.08757232129817482790e-09);
    c = c * z - R(2.75573143513906633035e-07);
    c = c * z + R(2.48015872894767294178e-05);
    c = c * z - R(1.38888888888741095749e-03);
    return c * z + R(4.16666666666666019037e-02);
}

#else

#define ISO_QUARTER_1 R(1.5703125)
#define ISO_QUARTER_2 R(4.837512969970703125e-4)
#define ISO_QUARTER_3 R(7.54978995489188216e-8)

static inline real iso_less_quarters(const real x, const real k)
{
    return ((x - k * ISO_QUARTER_1) - k * ISO_QUARTER_2) - k * ISO_QUARTER_3;
}

static inline real iso_sine_tail(const real z)
{
    const real s = R(-1.9515295891e-4) * z + R(8.3321608736e-3);
    return s * z - R(1.6666654611e-1);
}

static inline real iso_cosine_tail(const real z)
{
    const real c = R(2.443315711809948e-5) * z - R(1.388731625493765e-3);
    return c * z + R(4.166664568298827e-2);
}

#endif

static inline iso_sine_cosine iso_sincos(const real x)
{
    /* x = k pi/2 + r, |r| <= pi/4 (and a rounding), k in the low bits of the rounded sum. */
    const real rounded = x * R(0.636619772367581343) + ISO_ROUNDER;
    const real k = rounded - ISO_ROUNDER;
    const iso_bits quadrant = iso_bits_of(rounded);
    const real r = iso_less_quarters(x, k);

    const real z = r * r;
    const iso_bits s = iso_bits_of(r + r * (z * iso_sine_tail(z)));
    const iso_bits c = iso_bits_of(R(1.0) + z * (z * iso_cosine_tail(z) - R(0.5)));

    /* An odd quadrant swaps the two. Bit 1 of k negates the sine, bit 1 of k + 1 the cosine: both have the sign of the
     * sine, and the cosine one more where k is odd. */
    const iso_bits odd = iso_mask_of_lowest(quadrant);
    const iso_bits sine_sign = (quadrant << (ISO_SIGN_SHIFT - 1)) & ISO_SIGN_BIT;
    const iso_bits change = ((s ^ c) & odd) ^ sine_sign;
    const iso_sine_cosine result = {
        .sin = iso_real_of(s ^ change),
        .cos = iso_real_of((c ^ change) ^ (odd & ISO_SIGN_BIT)),
    };
    return result;
}

#endif
