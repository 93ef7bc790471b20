/* x to the power y, without a branch: exp(y log x).
 *
 * Domain: x >= 0. The error is at most 1 + 3 |y log x| ulp (tests/core/numbers/exhaustive/power.c): that of the
 * logarithm, two ulp, and that of the product count as often as the result's exponent is large. Of 0, and of what is
 * below the least normal number, it is 0 for y > 0 and an infinity for y < 0; so it is of results beyond the domain of
 * exp. NaN of x < 0, of 0 to the power 0, and of what is not finite. x^0 = 1 and 1^y = 1 exactly.
 */
#ifndef ISO_CORE_NUMBERS_POWER_H
#define ISO_CORE_NUMBERS_POWER_H

#include "core/numbers/log.h"

static inline real iso_power(const real x, const real y)
{
    const iso_bits size = iso_bits_of(x) & ~ISO_SIGN_BIT;
    const iso_bits none = iso_mask_of_sign(size - iso_bits_of(iso_all(ISO_REAL_LEAST)));
    /* -infinity of 0; x - x is 0, or a NaN of what is not finite. */
    const real logarithm = iso_real_of((iso_bits_of(iso_log(x)) & ~none) | (none & (ISO_SIGN_BIT | ISO_EXPONENT_BITS)));
    const real exponent = y * logarithm + (x - x);
    const iso_bits above = iso_less(iso_all(ISO_EXP_RANGE), exponent),
                   below = iso_less(exponent, iso_all(-ISO_EXP_RANGE));
    const iso_bits no_number = iso_mask_of_sign(ISO_EXPONENT_BITS - (iso_bits_of(exponent) & ~ISO_SIGN_BIT));
    const iso_bits finite = iso_bits_of(iso_exp(exponent)) & ~(above | below);
    return iso_real_of(finite | (above & ISO_EXPONENT_BITS) | no_number);
}

#endif
