/* The square root, correctly rounded as IEEE 754 demands: an instruction of the processor, or the function that the
 * compiler calls in its place (those of newlib and glibc are correctly rounded too), or that of a port. NaN below 0;
 * sqrt(-0) is -0.
 *
 * For the sake of errno a compiler adds a branch and a call of libm to the instruction: without -fno-math-errno gcc and
 * clang leave them out where the function is declared as constant, which has no effect beside its result. */
#ifndef ISO_CORE_NUMBERS_SQRT_H
#define ISO_CORE_NUMBERS_SQRT_H

#include "core/numbers/real.h"

#ifndef ISO_ROOT_OF_BITS /* a port's own function, from the bits of a number to those of its root */

#if defined __GNUC__ && !__STDC_HOSTED__ && !defined ISO_HAS_NO_MATH_ERRNO
#error "Isochron: with -ffreestanding a root calls libm, which sets errno; compile with -fno-math-errno"
#elif !defined __GNUC__ && !defined ISO_HAS_NO_MATH_ERRNO
#error                                                                                                                 \
    "Isochron: this compiler does not say whether a root sets errno; compile with -fno-math-errno -D__NO_MATH_ERRNO__"
#endif

#if defined __GNUC__ && defined ISO_HAS_NO_MATH_ERRNO
#define ISO_ROOT(name) __builtin_##name
#else
#define ISO_ROOT(name) name
#ifdef __GNUC__
#define ISO_CONSTANT __attribute__((const))
#else
#define ISO_CONSTANT
#endif
#ifdef __cplusplus
extern "C" {
#endif
ISO_CONSTANT double sqrt(double x);
ISO_CONSTANT float sqrtf(float x);
#ifdef __cplusplus
}
#endif
#endif

#endif

/* Without optimisation gcc takes the instruction by this attribute alone. */
#if defined __GNUC__ && !defined __clang__ && !defined __OPTIMIZE__ && !defined ISO_HAS_NO_MATH_ERRNO
#define ISO_BY_INSTRUCTION __attribute__((optimize("O1", "no-math-errno")))
#else
#define ISO_BY_INSTRUCTION
#endif

ISO_BY_INSTRUCTION static inline iso_scalar iso_scalar_sqrt(const iso_scalar x)
{
#ifdef ISO_ROOT_OF_BITS
    iso_word bits;
    memcpy(&bits, &x, sizeof bits);
    bits = ISO_ROOT_OF_BITS(bits);
    iso_scalar root;
    memcpy(&root, &bits, sizeof root);
    return root;
#elif defined ISO_REAL_DOUBLE
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
