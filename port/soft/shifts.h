/* What arithmetic without a branch is made of: masks, shifts, the count of leading zeros, rounding. All take a time that does
 * not follow from the numbers.
 *
 * A count of a shift is from 0 to 255; from 32 on nothing is left. A core with a barrel shifter takes the count modulo 32, and
 * a mask does the rest; an Arm core takes it as it is meant. A core that shifts by one place at a time would loop as often as
 * the count says: with SOFT_STAGES the shift is made of five of fixed counts, each of which a mask takes or leaves. */
#ifndef ISO_PORT_SOFT_SHIFTS_H
#define ISO_PORT_SOFT_SHIFTS_H

#include <stdint.h>

/* x as it is. From clang an empty statement hides that all bits of a mask are equal: it would make a branch of that. */
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
#elif defined __thumb__
#include "port/soft/thumb.h"
#else

#ifdef SOFT_STAGES

/* Where that bit of the count is set, what the shift by as many places made of x, else x. */
#define SOFT_STAGE(x, operator, count, bit)                                                                            \
    ((x) ^ (((x) ^ ((x) operator(1 << (bit)))) & soft_mask((uint32_t)(count) << (31 - (bit)))))

static inline uint32_t soft_left(const uint32_t x, const uint32_t count)
{
    const uint32_t x16 = SOFT_STAGE(x, <<, count, 4);
    const uint32_t x8 = SOFT_STAGE(x16, <<, count, 3);
    const uint32_t x4 = SOFT_STAGE(x8, <<, count, 2);
    const uint32_t x2 = SOFT_STAGE(x4, <<, count, 1);
    const uint32_t x1 = SOFT_STAGE(x2, <<, count, 0);
    return x1 & soft_mask((count & 0xFF) - 32);
}

static inline uint32_t soft_right(const uint32_t x, const uint32_t count)
{
    const uint32_t x16 = SOFT_STAGE(x, >>, count, 4);
    const uint32_t x8 = SOFT_STAGE(x16, >>, count, 3);
    const uint32_t x4 = SOFT_STAGE(x8, >>, count, 2);
    const uint32_t x2 = SOFT_STAGE(x4, >>, count, 1);
    const uint32_t x1 = SOFT_STAGE(x2, >>, count, 0);
    return x1 & soft_mask((count & 0xFF) - 32);
}

#else

static inline uint32_t soft_left(const uint32_t x, const uint32_t count)
{
    return (x << (count & 31)) & soft_mask((count & 0xFF) - 32);
}

static inline uint32_t soft_right(const uint32_t x, const uint32_t count)
{
    return (x >> (count & 31)) & soft_mask((count & 0xFF) - 32);
}

#endif

/* x, or 0 where its sign bit is set. */
static inline uint32_t soft_positive(const uint32_t x)
{
    return x & ~soft_mask(x);
}

/* x / 2^23 - 1, or 0 where that is negative; for x below 2^31. */
static inline uint32_t soft_upper(const uint32_t x)
{
    return soft_positive((x >> 23) - 1);
}

/* x + 2^23 upper, with 1 added where the bits that stand behind it are above a half, or a half and x is odd; of an odd x the
 * lowest of them is 0. The sum wraps where 1 is to be added. */
static inline uint32_t soft_rounded(const uint32_t x, const uint32_t behind, const uint32_t upper)
{
    const uint32_t most = UINT32_MAX >> 1;
    const uint32_t sum = behind + (x & 1) + most;
    return x + (sum < most) + (upper << 23);
}

/* x shifted left by 2^log places where is_empty is 1, not where it is 0. */
static inline uint32_t soft_raised(const uint32_t x, const uint32_t is_empty, const uint32_t log)
{
#ifdef SOFT_STAGES
    return x ^ ((x ^ (x << (1U << log))) & soft_hidden(0 - is_empty));
#else
    return x << (is_empty << log);
#endif
}

/* The zeros above the highest one of x: the count that shifts this to the top. Of 0 it is 31 or 32. */
static inline uint32_t soft_zeros(const uint32_t x)
{
    const uint32_t empty16 = ((x >> 16) - 1) >> 31;
    const uint32_t x16 = soft_raised(x, empty16, 4);
    const uint32_t empty8 = ((x16 >> 24) - 1) >> 31;
    const uint32_t x8 = soft_raised(x16, empty8, 3);
    const uint32_t empty4 = ((x8 >> 28) - 1) >> 31;
    const uint32_t x4 = soft_raised(x8, empty4, 2);
    const uint32_t empty2 = ((x4 >> 30) - 1) >> 31;
    const uint32_t x2 = soft_raised(x4, empty2, 1);
    return (empty16 << 4) + (empty8 << 3) + (empty4 << 2) + (empty2 << 1) + (~x2 >> 31);
}

#endif

#endif
