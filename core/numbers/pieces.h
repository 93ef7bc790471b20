/* Functions in pieces: sign, floor, rounding, and a value where a condition holds. Without a branch, exact. */
#ifndef ISO_CORE_NUMBERS_PIECES_H
#define ISO_CORE_NUMBERS_PIECES_H

#include "core/numbers/real.h"

/* 1, 0 or -1; 0 for both zeros, with their sign. The negative of a size that is not 0 has the sign bit. */
static inline real iso_sign(const real x)
{
    const iso_bits sign = iso_bits_of(x) & ISO_SIGN_BIT, size = iso_bits_of(x) ^ sign;
    const iso_bits any = iso_mask_of_sign(0 - size);
    return iso_real_of(sign | (any & iso_bits_of(R(1.0))));
}

/* The largest whole number that is not above x; x itself for infinities, a NaN for a NaN. Adding 2^23 (in double 2^52)
 * to a size below that rounds it to a whole number; one above that is whole. */
static inline real iso_floor(const real x)
{
    const real whole = iso_all(ISO_SCALAR(1.0) / ISO_REAL_EPSILON);
    const real size = iso_abs(x);
    const real rounded = iso_select(iso_beyond(x, whole), size, (size + whole) - whole);
    const real nearest = iso_real_of(iso_bits_of(rounded) | (iso_bits_of(x) & ISO_SIGN_BIT));
    return nearest - iso_above(nearest, x);
}

/* The nearest whole number, of two the even one; x itself for infinities, a NaN for a NaN. Adding 2^23 (in double 2^52)
 * with the sign of x rounds a size below that to a whole number. Beyond, where all are whole, zero is added. */
static inline real iso_round(const real x)
{
    const real whole = iso_all(ISO_SCALAR(1.0) / ISO_REAL_EPSILON);
    const iso_bits sign = iso_bits_of(x) & ISO_SIGN_BIT, size = iso_bits_of(x) ^ sign;
    const iso_bits is_small = iso_mask_of_sign(size - iso_bits_of(whole));
    const real rounder = iso_real_of((iso_bits_of(whole) & is_small) | sign);
    return (x + rounder) - rounder;
}

/* A condition is 1 or 0, as iso_above gives it. x where it holds, else +0; and below, where it does not, else +0. */
static inline real iso_where(const real condition, const real x)
{
    return iso_select(iso_less(R(0.5), condition), x, R(0.0));
}

/* x where the condition holds, else a NaN. */
static inline real iso_only(const real condition, const real x)
{
    return iso_real_of(iso_bits_of(x) | iso_less(condition, R(0.5)));
}

static inline real iso_unless(const real condition, const real x)
{
    return iso_select(iso_less(R(0.5), condition), R(0.0), x);
}

#endif
