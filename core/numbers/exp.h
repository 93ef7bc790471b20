/* The exponential without a branch, in + - * and the bits of the result.
 *
 * Domain |x| <= 87.33 in float and 708.39 in double; error at most 1 ulp there, and monotonic: in float every number
 * was tried (tests/core/numbers/exhaustive/exp.c). Beyond, also for an infinity, the result is that of the end of the
 * domain: 1.2e-38 or 8.5e37, in double 2.2e-308 or 4.5e307. A NaN counts as an infinity of its sign. exp(0) = 1
 * exactly.
 *
 * Reduction x = k ln 2 + r, |r| <= ln(2) / 2: Cody and Waite (1980), Software Manual for the Elementary Functions, ch.
 * 6; ln 2 in two parts, the first so short that k times it is exact. Then 1 + (r + r^2 q(r)) with a minimax polynomial
 * q by Remez's exchange, relative to the result (Muller 2016, Elementary Functions, 3rd ed., sec. 3.5 and 11.3).
 */
#ifndef ISO_CORE_NUMBERS_EXP_H
#define ISO_CORE_NUMBERS_EXP_H

#include "core/numbers/real.h"

#ifdef ISO_REAL_DOUBLE

#define ISO_EXP_RANGE R(708.3964185322641) /* 1022 ln 2 and less: e^-x is a normal number */
#define ISO_LN2_HIGH R(6.93147180369123816490e-01)
#define ISO_LN2_LOW R(1.90821492927058781614e-10)

/* (e^r - 1 - r) / r^2 */
static inline real iso_exp_tail(const real r)
{
    real q = R(2.08197400487448315e-09);
    q = q * r + R(2.51023709144907149e-08);
    q = q * r + R(2.75575367305343690e-07);
    q = q * r + R(2.75572631507376598e-06);
    q = q * r + R(2.48015870855495087e-05);
    q = q * r + R(1.98412698684041202e-04);
    q = q * r + R(1.38888888889589137e-03);
    q = q * r + R(8.33333333332734495e-03);
    q = q * r + R(4.16666666666666366e-02);
    q = q * r + R(1.66666666666666741e-01);
    return q * r + R(0.5);
}

#else

#define ISO_EXP_RANGE R(87.3365402) /* 126 ln 2 and less */
#define ISO_LN2_HIGH R(0.693359375)
#define ISO_LN2_LOW R(-2.12194440e-4)

static inline real iso_exp_tail(const real r)
{
    real q = R(1.383890514e-3);
    q = q * r + R(8.369193412e-3);
    q = q * r + R(4.166810215e-2);
    q = q * r + R(1.666651666e-1);
    return q * r + R(4.999999404e-1);
}

#endif

static inline real iso_exp(const real x)
{
    const real limited = iso_limited(x, ISO_EXP_RANGE);
    const real rounded = limited * R(1.44269504088896341) + ISO_ROUNDER;
    const real k = rounded - ISO_ROUNDER;
    const real r = (limited - k * ISO_LN2_HIGH) - k * ISO_LN2_LOW;
    const real e = R(1.0) + (r + r * r * iso_exp_tail(r));
    /* 2^k e: k, from the low bits of the rounded sum, is added to the exponent. */
    return iso_real_of(iso_bits_of(e) + (iso_bits_of(rounded) << ISO_EXPONENT_SHIFT));
}

#endif
