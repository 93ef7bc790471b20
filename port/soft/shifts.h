/* The parts of arithmetic without a branch: masks, shifts, the count of leading zeros, rounding. All take a time
 * that does not follow from the numbers.
 *
 * A count of a shift is from 0 to 255; from 32 on nothing is left. A core with a barrel shifter takes the count modulo
 * 32, and a mask does the rest; an Arm core takes the whole count. A core that shifts by one place at a time would loop
 * as often as the count says: with SOFT_STAGES a shift is made of several of fixed counts (stages.h). gcc takes the
 * statements of thumb.h with -masm-syntax-unified alone: who cannot give that defines SOFT_PORTABLE. */
#ifndef ISO_PORT_SOFT_SHIFTS_H
#define ISO_PORT_SOFT_SHIFTS_H

#include <stdint.h>

/* Returns x. From clang an empty statement hides that all bits of a mask are equal: it would make a branch of it. */
static inline uint32_t soft_hidden(uint32_t x)
{
#ifdef __clang__
    __asm__("" : "+r"(x));
#endif
    return x;
}

/* All ones where the sign bit of x is set, else zero. */
static inline uint32_t soft_mask(const uint32_t x)
{
    return soft_hidden(0 - (x >> 31));
}

/* a where the sign bit of x is set, else b. */
static inline uint32_t soft_select(const uint32_t x, const uint32_t a, const uint32_t b)
{
    return (a & soft_mask(x)) | (b & ~soft_mask(x));
}

/* 1 where x is not zero, else 0. */
static inline uint32_t soft_nonzero(const uint32_t x)
{
    return soft_hidden(x | (0 - x)) >> 31;
}

#if defined __thumb2__
#include "port/soft/thumb2.h"
#elif defined __thumb__ && !defined SOFT_PORTABLE
#include "port/soft/thumb.h"
#elif defined SOFT_STAGES
#include "port/soft/stages.h"
#else

static inline uint32_t soft_left(const uint32_t x, const uint32_t count)
{
    return (x << (count & 31)) & soft_mask((count & 0xFF) - 32);
}

static inline uint32_t soft_right(const uint32_t x, const uint32_t count)
{
    return (x >> (count & 31)) & soft_mask((count & 0xFF) - 32);
}

/* The zeros above the highest one of x: the count that shifts this to the top. Of 0 it is 31 or 32. */
static inline uint32_t soft_zeros(const uint32_t x)
{
    const uint32_t zeros16 = ((x >> 16) - 1) >> 31 << 4;
    const uint32_t x16 = x << zeros16;
    const uint32_t zeros8 = ((x16 >> 24) - 1) >> 31 << 3;
    const uint32_t x8 = x16 << zeros8;
    const uint32_t zeros4 = ((x8 >> 28) - 1) >> 31 << 2;
    const uint32_t x4 = x8 << zeros4;
    const uint32_t zeros2 = ((x4 >> 30) - 1) >> 31 << 1;
    return zeros16 + zeros8 + zeros4 + zeros2 + (~(x4 << zeros2) >> 31);
}

#endif

#ifndef SOFT_STAGES

/* x by 23 places to the left, where it is below 2^9, and to the right: to the exponent of a number and back. */
static inline uint32_t soft_up(const uint32_t x)
{
    return x << 23;
}

static inline uint32_t soft_down(const uint32_t x)
{
    return x >> 23;
}

#endif

#ifndef __thumb2__

/* x, or 0 where its sign bit is set. */
static inline uint32_t soft_positive(const uint32_t x)
{
    return x & ~soft_mask(x);
}

/* x / 2^23 - 1, or 0 where that is negative; for x below 2^31. */
static inline uint32_t soft_upper(const uint32_t x)
{
    return soft_positive(soft_down(x) - 1);
}

#endif

#if !defined ISO_PORT_SOFT_THUMB_H && !defined ISO_PORT_SOFT_THUMB2_H

/* x + 2^23 upper, with 1 added where the bits that stand behind it are above a half, or a half and x is odd; of an
 * odd x the lowest of them is 0. The sum wraps where 1 is to be added. */
static inline uint32_t soft_rounded(const uint32_t x, const uint32_t behind, const uint32_t upper)
{
    const uint32_t most = UINT32_MAX >> 1;
    const uint32_t sum = behind + (x & 1) + most;
    return x + (sum < most) + soft_up(upper);
}

#endif

#endif
