/* The square root, correctly rounded as IEEE 754 demands: an instruction of the processor, or the function that the
 * compiler calls in its place (those of newlib and glibc are correctly rounded too). NaN below 0; sqrt(-0) is -0. */
#ifndef ISO_CORE_NUMBERS_SQRT_H
#define ISO_CORE_NUMBERS_SQRT_H

#include "core/numbers/real.h"

#ifndef __NO_MATH_ERRNO__
#error "Isochron: for the sake of errno a root has a branch and calls libm; compile with -fno-math-errno"
#endif

static inline iso_scalar iso_scalar_sqrt(const iso_scalar x)
{
#ifdef ISO_REAL_DOUBLE
    return __builtin_sqrt(x);
#else
    return __builtin_sqrtf(x);
#endif
}

static inline real iso_sqrt(const real x)
{
#ifdef ISO_LANES
    real root;
    for (unsigned lane = 0; lane < ISO_LANES; lane++) {
        root[lane] = iso_scalar_sqrt(x[lane]);
    }
    return root;
#else
    return iso_scalar_sqrt(x);
#endif
}

#endif
