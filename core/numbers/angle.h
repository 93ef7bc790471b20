/* The angle of a point, and from it the inverse sine and cosine, without a branch, in + - * / sqrt and bits.
 *
 * iso_atan2: all y and x; error at most 4 ulp, where the result is a normal number
 * (tests/core/numbers/exhaustive/angle.c). The zeros as in C: atan2(0, x >= +0) is 0, atan2(0, x <= -0) is pi, with the
 * sign of y. Of two infinities it is NaN, as of a NaN. iso_asin, iso_acos: |x| <= 1, error at most 4 ulp; beyond NaN.
 * acos(1) = 0 exactly.
 *
 * The smaller of |y| and |x| over the larger is t <= 1; above tan(pi/8) atan t = pi/4 + atan((t - 1) / (t + 1)); then
 * t + t^3 q(t^2) with a minimax polynomial by Remez's exchange (Muller 2016, Elementary Functions, sec. 3.5; Cody and
 * Waite 1980, Software Manual for the Elementary Functions, ch. 11).
 */
#ifndef ISO_CORE_NUMBERS_ANGLE_H
#define ISO_CORE_NUMBERS_ANGLE_H

#include "core/numbers/sqrt.h"

/* (atan(t) - t) / t^3 of z = t^2, |t| <= tan(pi/8) */
#ifdef ISO_REAL_DOUBLE

static inline real iso_atan_tail(const real z)
{
    real q = -R(1.80414969629898517e-02);
    q = q * z + R(3.81965277112604473e-02);
    q = q * z - R(5.04493073728265323e-02);
    q = q * z + R(5.84925234267237165e-02);
    q = q * z - R(6.66331052192042361e-02);
    q = q * z + R(7.69208048088145246e-02);
    q = q * z - R(9.09089904927069814e-02);
    q = q * z + R(1.11111108354910559e-01);
    q = q * z - R(1.42857142814401733e-01);
    q = q * z + R(1.99999999999690675e-01);
    return q * z - R(3.33333333333332704e-01);
}

#else

static inline real iso_atan_tail(const real z)
{
    real q = R(8.049804717e-2);
    q = q * z - R(1.387655139e-1);
    q = q * z + R(1.997761428e-1);
    return q * z - R(3.33329469e-1);
}

#endif

/* The angle of the point (x, y) from the x axis, in [-pi, pi]. */
static inline real iso_atan2(const real y, const real x)
{
    const iso_bits up = iso_bits_of(y) & ~ISO_SIGN_BIT, right = iso_bits_of(x) & ~ISO_SIGN_BIT;
    const iso_bits steep = iso_mask_of_sign(right - up); /* |y| > |x| */
    const iso_bits back = iso_mask_of_sign(iso_bits_of(x));
    const iso_bits swap = (up ^ right) & steep;
    /* Halves of operands so large that their sum could be infinite: the quotient is the same. */
    const iso_bits large = iso_mask_of_sign(iso_bits_of(ISO_REAL_MAX * R(0.5)) - (right ^ swap));
    const real scale = iso_real_of(iso_bits_of(R(1.0)) - (large & ((iso_word)1 << ISO_EXPONENT_SHIFT)));
    const real low = iso_real_of(up ^ swap) * scale, high = iso_real_of(right ^ swap) * scale;

    /* Above tan(pi/8) the angle less pi/4; 0 / 0 becomes 0 / 1. */
    const iso_bits turned = iso_less(high * R(0.414213562373095049), low);
    const iso_bits none = iso_mask_of_sign(iso_bits_of(high) - 1);
    const real over = low - iso_real_of(iso_bits_of(high) & turned);
    const real under =
        iso_real_of(iso_bits_of(high) | (iso_bits_of(R(1.0)) & none)) + iso_real_of(iso_bits_of(low) & turned);
    const real t = over / under;
    const real z = t * t;
    const real eighth = (t + t * (z * iso_atan_tail(z))) + iso_real_of(iso_bits_of(R(0.785398163397448310)) & turned);

    /* Mirrored at the diagonal where steep, at the y axis where back; then the sign of y. */
    const iso_bits mirrored = (steep ^ back) & ISO_SIGN_BIT;
    const real base =
        iso_select(steep, R(1.57079632679489662), iso_real_of(iso_bits_of(R(3.14159265358979324)) & back));
    const real angle = base + iso_real_of(iso_bits_of(eighth) ^ mirrored);
    return iso_real_of(iso_bits_of(angle) ^ (iso_bits_of(y) & ISO_SIGN_BIT));
}

static inline real iso_asin(const real x)
{
    return iso_atan2(x, iso_sqrt((R(1.0) - x) * (R(1.0) + x)));
}

static inline real iso_acos(const real x)
{
    return iso_atan2(iso_sqrt((R(1.0) - x) * (R(1.0) + x)), x);
}

#endif
