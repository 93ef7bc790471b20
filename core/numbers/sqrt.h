/* The square root, correctly rounded as IEEE 754 demands: an instruction of the processor, or the function that the
 * compiler calls in its place (those of newlib and glibc are correctly rounded too). NaN below 0; sqrt(-0) is -0. */
#ifndef ISO_CORE_NUMBERS_SQRT_H
#define ISO_CORE_NUMBERS_SQRT_H

#include "core/numbers/real.h"

#ifndef ISO_HAS_NO_MATH_ERRNO
#if defined __GNUC__ && !(defined __clang__ && __clang_major__ < 14)
#error "Isochron: for the sake of errno a root has a branch and calls libm; compile with -fno-math-errno"
#else
#error                                                                                                                 \
    "Isochron: this compiler does not say whether a root sets errno; compile with -fno-math-errno -D__NO_MATH_ERRNO__"
#endif
#endif

#ifdef __GNUC__
#define ISO_ROOT(name) __builtin_##name
#else
#define ISO_ROOT(name) name
double sqrt(double x);
float sqrtf(float x);
#endif

static inline iso_scalar iso_scalar_sqrt(const iso_scalar x)
{
#ifdef ISO_REAL_DOUBLE
    return ISO_ROOT(sqrt)(x);
#else
    return ISO_ROOT(sqrtf)(x);
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
