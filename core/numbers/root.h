/* 1 / sqrt(x), of a root and a division: each is an instruction where the processor has it, and correctly rounded.
 *
 * Domain: x >= 2^-101, in double 2^-968; error at most 1.5 ulp (tests/core/numbers/exhaustive/root.c). The least normal
 * number is added, a quarter of an ulp of these, which changes no x of the domain; so of 0 the result is finite, and 0
 * times it is 0.
 */
#ifndef ISO_CORE_NUMBERS_ROOT_H
#define ISO_CORE_NUMBERS_ROOT_H

#include "core/numbers/sqrt.h"

static inline real iso_inverse_root(const real x)
{
    return R(1.0) / iso_sqrt(x + iso_all(ISO_REAL_LEAST));
}

#endif
