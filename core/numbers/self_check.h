/* Whether this program computes with the bits that are promised: a short run of arithmetic against its stored result.
 *
 * It finds faults that no preprocessor sees: products fused with sums by an option that overrides core/numbers/real.h,
 * division by a reciprocal, sums in another order, zeros without a sign, numbers near zero flushed to it or another
 * rounding than to nearest by a mode of the processor, x87, a difference of doubles that a library rounds wrongly. It
 * sees the flags of the file that includes it and the mode of the processor. A plant that stands alone has it among its
 * own code.
 */
#ifndef ISO_CORE_NUMBERS_SELF_CHECK_H
#define ISO_CORE_NUMBERS_SELF_CHECK_H

#include <stdbool.h>

#include "core/numbers/real.h"
#include "core/numbers/unroll.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Fowler, Noll and Vo's hash FNV-1a, over a real at a time. */
static inline iso_bits iso_check_continued(const iso_bits hash, const real x)
{
    return (hash ^ iso_bits_of(x)) * 16777619U;
}

/* Lorenz (1963) by Euler steps, with divisions by one number and a rounding to a whole one: every rounding of a state
 * or a derivative shows. A fused product, a division by a reciprocal and a wider register round otherwise. */
static inline iso_bits iso_check_run(iso_bits hash, const real unit)
{
    enum { STEPS = 24 };
    const real h = unit / R(64.0);
    real x = unit, y = unit, z = R(20.0) * unit;
    for (int i = 0; i < STEPS; i++) {
        const real around = R(3.0) + x * x;
        const real whole = (y + ISO_ROUNDER) - ISO_ROUNDER;
        const real dx = R(10.0) * (y - x) + (y - whole) / around;
        const real dy = x * (R(28.0) - z) - y;
        const real dz = x * y - (z / R(0.375) - x / R(7.0)) / around;
        x += h * dx;
        y += h * dy;
        z += h * dz;
        hash = iso_check_continued(iso_check_continued(iso_check_continued(hash, x), y), dz);
    }
    return hash;
}

/* Below the least normal number: neither a result nor an operand may become zero; and the sum of both zeros is +0. */
static inline iso_bits iso_check_small(iso_bits hash, const real unit)
{
    const real part = R(0.375) * (ISO_REAL_LEAST * unit);
    const real negative = iso_real_of(iso_bits_of(part - part) | ISO_SIGN_BIT);
    hash = iso_check_continued(iso_check_continued(hash, part), R(4.0) * part);
    hash = iso_check_continued(hash, negative + R(0.0));
    return iso_check_continued(hash, unit - R(1.9247219996630951e-10) * unit);
}

/* True if the bits are right. About a thousand instructions where there is a floating-point unit; for the start. */
ISO_RARE static inline bool iso_bits_are_kept(void)
{
#ifdef ISO_REAL_DOUBLE
    const iso_word expected = UINT64_C(0x5DF47530E179F9A9);
#else
    const iso_word expected = UINT32_C(0xD3D923B4);
#endif
    volatile real one = R(1.0); /* the compiler does not know it, so that the processor computes */
    const real unit = one;
    return !iso_any(iso_check_small(iso_check_run(ISO_NOTHING + 1, unit), unit) ^ expected);
}

/* x if the bits are right, else a NaN. */
static inline real iso_if_bits_are_kept(const real x)
{
    return iso_bits_are_kept() ? x : iso_real_of(ISO_NOTHING + ~ISO_SIGN_BIT);
}

#define iso_self_check ISO_REAL_NAME(iso_self_check)

/* The same by the flags of core/numbers/self_check.c: compile it with those of the plant. */
bool iso_self_check(void);

#ifdef __cplusplus
}
#endif

#endif
