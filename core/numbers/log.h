/* The natural logarithm without a branch, in + - * / and bits.
 *
 * Domain: the normal positive numbers; error at most 2 ulp there (tests/core/numbers/exhaustive/log.c). Below the least
 * normal number, for 0 and -0 too, the result is that of the least: -87.3, in double -708.4. Below 0 it is NaN. An
 * infinity gives 88.7, in double 709.8, and a positive NaN little more. log(1) = 0 exactly.
 *
 * x = 2^k m with m from sqrt(1/2) to sqrt(2); log m = 2 artanh s with s = (m - 1) / (m + 1), as 2 s + s^3 q(s^2) with a
 * minimax polynomial q by Remez's exchange (Muller 2016, Elementary Functions, sec. 11.4; Sun's fdlibm, 1993, e_log.c).
 */
#ifndef ISO_CORE_NUMBERS_LOG_H
#define ISO_CORE_NUMBERS_LOG_H

#include "core/numbers/exp.h" /* ln 2 in two parts */

#ifdef ISO_REAL_DOUBLE

/* (2 artanh(s) - 2 s) / s^3 of z = s^2 */
static inline real iso_log_tail(const real z)
{
    real q = R(1.47985851714285327e-01);
    q = q * z + R(1.53138045682131324e-01);
    q = q * z + R(1.81835732292057822e-01);
    q = q * z + R(2.22221984162451092e-01);
    q = q * z + R(2.85714287437693115e-01);
    q = q * z + R(3.99999999994091693e-01);
    return q * z + R(6.66666666666673513e-01);
}

#else

static inline real iso_log_tail(const real z)
{
    const real q = R(2.98712343e-1) * z + R(3.997757435e-1);
    return q * z + R(6.666677594e-1);
}

#endif

static inline real iso_log(const real x)
{
    const iso_bits size = iso_bits_of(x) & ~ISO_SIGN_BIT, least = iso_bits_of(iso_all(ISO_REAL_LEAST));
    const iso_bits above = size - least;
    const iso_bits normal = least + (above & ~iso_mask_of_sign(above));
    /* The exponent of x / sqrt(1/2), biased by 128 so that it is not negative. */
    const iso_word bias = (iso_word)128 << ISO_EXPONENT_SHIFT << (ISO_SIGN_SHIFT == 63 ? 3 : 0);
    const iso_bits biased = normal - iso_bits_of(R(0.707106781186547524)) + bias;
    const iso_bits exponent = (biased >> ISO_EXPONENT_SHIFT) - (bias >> ISO_EXPONENT_SHIFT);
    const real k = iso_real_of_whole(exponent);

    const real f = iso_real_of(normal - (exponent << ISO_EXPONENT_SHIFT)) - R(1.0);
    const real s = f / (R(2.0) + f);
    const real z = s * s;
    const real sum = k * ISO_LN2_HIGH + ((s + s) + (s * (z * iso_log_tail(z)) + k * ISO_LN2_LOW));
    /* All ones, a NaN, where the sign is set and the size is not 0. */
    const iso_bits negative = iso_mask_of_sign(iso_bits_of(x) & (0 - size));
    return iso_real_of(iso_bits_of(sum) | negative);
}

#endif
