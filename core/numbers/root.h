/* 1 / sqrt(x) without a branch, in + - * and the bits of the argument: some 31 cycles of the Cortex-M4F, where VSQRT
 * and VDIV take 36 with the waits for their results, and no libm on a target that has no root.
 *
 * Domain: normal x > 0, error at most 1.5 ulp (tests/exhaustive/root.c). For 0 and below the least normal number the
 * result is finite, so that 0 times it is 0.
 *
 * Half of the exponent and a line through each binade from integer arithmetic, error at most 3.5 % (Lomont 2003, Fast
 * inverse square root), then Newton's iterations, each of which leaves 3/2 of the error's square.
 */
#ifndef ISO_CORE_NUMBERS_ROOT_H
#define ISO_CORE_NUMBERS_ROOT_H

#include "core/numbers/real.h"

static inline real iso_inverse_root(const real x)
{
    const real half = R(0.5) * x;
#ifdef ISO_REAL_DOUBLE
    real y = iso_real_of(UINT64_C(0x5FE6EB50C7B537A9) - (iso_bits_of(x) >> 1));
    y = y * (R(1.5) - half * y * y);
#else
    real y = iso_real_of(UINT32_C(0x5F375A86) - (iso_bits_of(x) >> 1));
#endif
    y = y * (R(1.5) - half * y * y);
    y = y * (R(1.5) - half * y * y);
    return y + y * (R(0.5) - half * y * y);
}

#endif
