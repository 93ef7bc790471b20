/* The parts of arithmetic without a branch (shifts.h) for words of 64 bits, of which a core has the halves. A count of
 * a shift is from 0 to 255; from 64 on nothing is left. */
#ifndef ISO_PORT_SOFT_WIDE_H
#define ISO_PORT_SOFT_WIDE_H

#include <stdint.h>

#include "port/soft/shifts.h"

static inline uint32_t wide_high(const uint64_t x)
{
    return (uint32_t)(x >> 32);
}

static inline uint64_t wide_of(const uint32_t high, const uint32_t low)
{
    return (uint64_t)high << 32 | low;
}

/* All ones where the sign bit of a word of 32 bits is set, else zero. */
static inline uint64_t wide_mask(const uint32_t sign)
{
    const uint32_t mask = soft_mask(sign);
    return wide_of(mask, mask);
}

/* a where the sign bit of a word of 32 bits is set, else b. */
static inline uint64_t wide_select(const uint32_t sign, const uint64_t a, const uint64_t b)
{
    const uint64_t mask = wide_mask(sign);
    return (a & mask) | (b & ~mask);
}

static inline uint32_t wide_nonzero(const uint64_t x)
{
    return soft_nonzero(wide_high(x) | (uint32_t)x);
}

/* A count below 2^31, or 127 where it is larger. */
static inline uint32_t wide_count(const uint32_t count)
{
    const uint32_t left = 127 - count;
    return count + (left & soft_mask(left));
}

static inline uint64_t wide_left(const uint64_t x, const uint32_t count)
{
    const uint32_t high = wide_high(x), low = (uint32_t)x;
    return wide_of(soft_left(high, count) | soft_right(low, 32 - count) | soft_left(low, count - 32),
                   soft_left(low, count));
}

static inline uint64_t wide_right(const uint64_t x, const uint32_t count)
{
    const uint32_t high = wide_high(x), low = (uint32_t)x;
    return wide_of(soft_right(high, count),
                   soft_right(low, count) | soft_left(high, 32 - count) | soft_right(high, count - 32));
}

/* By a count from 1 to 31 that the compiler knows. */
static inline uint64_t wide_up(const uint64_t x, const unsigned count)
{
    return wide_of(wide_high(x) << count | (uint32_t)x >> (32 - count), (uint32_t)x << count);
}

static inline uint64_t wide_down(const uint64_t x, const unsigned count)
{
    return wide_of(wide_high(x) >> count, (uint32_t)x >> count | wide_high(x) << (32 - count));
}

/* The zeros above the highest one of x: the count that shifts this to the top. Of 0 it is 63 or 64. */
static inline uint32_t wide_zeros(const uint64_t x)
{
    const uint32_t is_short = soft_nonzero(wide_high(x)) ^ 1;
    return soft_zeros(wide_high(x) | ((uint32_t)x & (0 - is_short))) + (is_short << 5);
}

/* The product of two words of 32 bits. */
static inline uint64_t wide_product(const uint32_t a, const uint32_t b)
{
#ifdef SOFT_PIECES
    const uint32_t a_high = a >> 16, a_low = a & 0xFFFF, b_high = b >> 16, b_low = b & 0xFFFF;
    const uint32_t low = a_low * b_low, left = a_high * b_low, right = a_low * b_high;
    const uint32_t middle = (low >> 16) + (left & 0xFFFF) + (right & 0xFFFF);
    return wide_of(a_high * b_high + (left >> 16) + (right >> 16) + (middle >> 16), middle << 16 | (low & 0xFFFF));
#else
    return (uint64_t)a * b;
#endif
}

/* The upper half of a product; the lowest bit shows whether any lower bit was set. */
static inline uint64_t wide_upper_product(const uint64_t a, const uint64_t b)
{
    const uint64_t low = wide_product((uint32_t)a, (uint32_t)b), left = wide_product(wide_high(a), (uint32_t)b);
    const uint64_t right = wide_product((uint32_t)a, wide_high(b));
    const uint64_t middle = (uint64_t)wide_high(low) + (uint32_t)left + (uint32_t)right;
    const uint64_t upper =
        wide_product(wide_high(a), wide_high(b)) + wide_high(left) + wide_high(right) + wide_high(middle);
    return upper | soft_nonzero((uint32_t)middle | (uint32_t)low);
}

#endif
