/* Arithmetic of IEEE 754 binary64 on the bits of numbers, without a branch, in the same way as that of binary32.h,
 * which explains its words and its NaN. */
#ifndef ISO_PORT_SOFT_BINARY64_H
#define ISO_PORT_SOFT_BINARY64_H

#include <stdint.h>

#include "port/soft/binary32.h"
#include "port/soft/wide.h"

#define SOFT64_SIGN UINT64_C(0x8000000000000000)
#define SOFT64_MAGNITUDE UINT64_C(0x7FFFFFFFFFFFFFFF)
#define SOFT64_INFINITY UINT64_C(0x7FF0000000000000)
#define SOFT64_NAN UINT64_C(0x7FF8000000000000)

/* The exponent of 1; the places of the significand behind its top bit, and above it in a word. */
enum { SOFT64_BIAS = 1022, SOFT64_FRACTION = 52, SOFT64_ABOVE = 11, SOFT64_IS_QUIET = 51 };

/* An exponent in its place. */
static inline uint64_t soft64_up(const uint32_t exponent)
{
    return wide_of(exponent << (SOFT64_FRACTION - 32), 0);
}

static inline uint32_t soft64_down(const uint64_t x)
{
    return wide_high(x) >> (SOFT64_FRACTION - 32);
}

/* The exponent of a magnitude. */
static inline uint32_t soft64_upper(const uint64_t x)
{
    return soft_positive(soft64_down(x) - 1);
}

/* Has the sign bit set where the magnitude x is infinity or a NaN, is 0, or is a NaN. */
static inline uint32_t soft64_is_special(const uint64_t x)
{
    return wide_high(x + (SOFT64_SIGN - SOFT64_INFINITY));
}

static inline uint32_t soft64_is_zero(const uint64_t x)
{
    return wide_high(x - 1);
}

static inline uint32_t soft64_is_nan(const uint64_t x)
{
    return wide_high(SOFT64_INFINITY - x);
}

/* x, or infinity where it is beyond. */
static inline uint64_t soft64_limited(const uint64_t x)
{
    const uint64_t excess = x - SOFT64_INFINITY;
    return SOFT64_INFINITY + (excess & wide_mask(wide_high(excess)));
}

/* The magnitude with that exponent, and 1 added where the bits that stand behind x are above a half, or a half and x is
 * odd. */
static inline uint64_t soft64_rounded(const uint64_t x, const uint32_t behind, const uint32_t exponent)
{
    return soft64_limited(x + (behind >> 31 & (soft_nonzero(behind << 1) | ((uint32_t)x & 1))) + soft64_up(exponent));
}

/* Likewise with a significand of which the top bit is bit 63. */
static inline uint64_t soft64_rounded_top(const uint64_t significand, const uint32_t exponent)
{
    return soft64_rounded(wide_down(significand, SOFT64_ABOVE), (uint32_t)significand << (32 - SOFT64_ABOVE), exponent);
}

/* The magnitude with a significand of which the top bit is bit 62 + is_high. Its lowest bit shows whether any lower bit
 * was set. The exponent may be negative, or beyond infinity by up to 1100. */
static inline uint64_t soft64_packed(const uint64_t significand, const uint32_t is_high, const uint32_t exponent)
{
    const uint32_t positive = soft_positive(exponent);
    const uint32_t count = wide_count(SOFT64_ABOVE - 1 + is_high + (positive - exponent));
    const uint64_t behind = wide_left(significand, 64 - count);
    return soft64_rounded(wide_right(significand, count), wide_high(behind) | soft_nonzero((uint32_t)behind), positive);
}

/* The sum. The smaller magnitude y is shifted to the exponent of the larger, x. */
static inline uint64_t soft64_add(uint64_t a, uint64_t b)
{
    /* Both change places where the first is the smaller. */
    const uint64_t change = (a ^ b) & wide_mask(wide_high((a & SOFT64_MAGNITUDE) - (b & SOFT64_MAGNITUDE)));
    const uint32_t difference = wide_high(a ^ b);
    a ^= change;
    b ^= change;
    const uint64_t x = a & SOFT64_MAGNITUDE, y = b & SOFT64_MAGNITUDE;

    /* Significands with the top bit 61; the lowest bit of the shifted one shows whether any bit was lost. */
    const uint32_t x_exponent = soft64_upper(x), y_exponent = soft64_upper(y);
    const uint64_t high = wide_up(x - soft64_up(x_exponent), SOFT64_ABOVE - 2);
    const uint64_t low = wide_up(y - soft64_up(y_exponent), SOFT64_ABOVE - 2);
    const uint32_t count = wide_count(x_exponent - y_exponent);
    const uint64_t kept = wide_right(low, count);
    const uint64_t shifted = kept | wide_high(wide_left(kept, count) - low) >> 31;
    const uint64_t sum = high + (shifted ^ wide_mask(difference)) + (difference >> 31);

    /* The top bit of the sum goes to bit 63, as far as the exponent lets it. */
    const uint32_t is_zero = soft64_is_zero(sum) >> 31;
    const uint32_t target = x_exponent + 2;
    const uint32_t exponent = soft_positive(target - wide_zeros(sum) - (is_zero << 12));
    const uint64_t finite = soft64_rounded_top(wide_left(sum, target - exponent), exponent);

    /* An infinity or a NaN is the result, but for infinity less infinity. A sum of zero is +0, but for -0 - 0. */
    const uint64_t special = x | wide_of(is_zero << (SOFT64_IS_QUIET - 32), 0);
    const uint64_t magnitude = wide_select(soft64_is_special(x), special, finite);
    return magnitude | (a & SOFT64_SIGN & ~wide_of(difference & is_zero << 31, 0));
}

static inline uint64_t soft64_subtract(const uint64_t a, const uint64_t b)
{
    return soft64_add(a, b ^ SOFT64_SIGN);
}

/* Puts the top bit of the significand of y, at bit 63, into *significand. Returns its exponent, negative for numbers
 * below the least normal one. */
static inline uint32_t soft64_normalised(const uint64_t y, uint64_t *const significand)
{
    const uint32_t exponent = soft64_upper(y);
    const uint64_t bits = wide_up(y - soft64_up(exponent), SOFT64_ABOVE);
    const uint32_t zeros = wide_zeros(bits);
    *significand = wide_left(bits, zeros);
    return exponent - zeros;
}

/* The product. Where the larger magnitude x is below the least normal number too, the result is 0 whatever its
 * significand. */
static inline uint64_t soft64_multiply(const uint64_t a, const uint64_t b)
{
    uint64_t x = a & SOFT64_MAGNITUDE, y = b & SOFT64_MAGNITUDE;
    const uint64_t change = (x ^ y) & wide_mask(wide_high(x - y));
    x ^= change;
    y ^= change;

    uint64_t significand;
    const uint32_t is_zero = soft64_is_zero(y) >> 31; /* then the exponent becomes less than any */
    const uint32_t exponent = soft64_down(x) + soft64_normalised(y, &significand) - (is_zero << 16);
    const uint64_t product = wide_upper_product(wide_up(x, SOFT64_ABOVE) | SOFT64_SIGN, significand);
    const uint32_t is_high = wide_high(product) >> 31;
    const uint64_t finite = soft64_packed(product, is_high, exponent + is_high - (SOFT64_BIAS + 1));

    /* An infinity or a NaN is the result, but for infinity times zero. */
    const uint64_t special = x | wide_of(is_zero << (SOFT64_IS_QUIET - 32), 0);
    return wide_select(soft64_is_special(x), special, finite) | ((a ^ b) & SOFT64_SIGN);
}

/* The quotient, a bit at a time. */
static inline uint64_t soft64_divide(const uint64_t a, const uint64_t b)
{
    const uint64_t x = a & SOFT64_MAGNITUDE, y = b & SOFT64_MAGNITUDE;
    uint64_t rest, divisor;
    const uint32_t x_exponent = soft64_normalised(x, &rest), y_exponent = soft64_normalised(y, &divisor);
    uint64_t quotient = 0;
    rest = wide_down(rest, SOFT64_ABOVE);
    divisor = wide_down(divisor, SOFT64_ABOVE);
    for (int bit = 0; bit < SOFT64_FRACTION + 3; bit++) {
        const uint64_t less = rest - divisor;
        const uint64_t is_below = wide_mask(wide_high(less));
        rest = wide_up(less + (divisor & is_below), 1);
        quotient = wide_up(quotient, 1) + 1 + is_below;
    }
    /* The top bit of the quotient is bit 54 or 53, of the significand 63 or 62. */
    const uint64_t significand = wide_up(quotient, SOFT64_ABOVE - 2) | wide_nonzero(rest);
    const uint32_t is_high = wide_high(significand) >> 31;
    const uint64_t finite = soft64_packed(significand, is_high, x_exponent - y_exponent + is_high + (SOFT64_BIAS - 1));

    /* Operands that are zero, infinite or NaN: as in binary32.h. */
    const uint32_t x_zero = soft64_is_zero(x), y_zero = soft64_is_zero(y);
    const uint32_t x_special = soft64_is_special(x), y_special = soft64_is_special(y);
    const uint32_t none = (x_zero & y_zero) | (x_special & y_special) | soft64_is_nan(x) | soft64_is_nan(y);
    const uint64_t infinite = wide_select(y_zero | x_special, SOFT64_INFINITY, finite);
    const uint64_t limited = wide_select(x_zero | y_special, 0, infinite);
    return wide_select(none, SOFT64_NAN, limited) | ((a ^ b) & SOFT64_SIGN);
}

/* The square root, a bit at a time: the square of the root so far is subtracted. */
static inline uint64_t soft64_root(const uint64_t a)
{
    const uint64_t x = a & SOFT64_MAGNITUDE;
    uint64_t significand;
    const uint32_t exponent = soft64_normalised(x, &significand) + 2 * (SOFT64_BIAS + 2);
    uint64_t rest = wide_down(significand, SOFT64_ABOVE - 1);
    rest += rest & (0 - (uint64_t)(exponent & 1));
    uint64_t root = 0;
    for (uint64_t bit = UINT64_C(1) << (SOFT64_FRACTION + 1); bit != 0; bit = wide_down(bit, 1)) {
        const uint64_t square = wide_up(root, 1) + bit;
        const uint64_t less = rest - square;
        const uint64_t is_below = wide_mask(wide_high(less));
        rest = wide_up(less + (square & is_below), 1);
        root += bit & ~is_below;
    }
    /* One bit more than the significand has, and no root lies halfway between two numbers. */
    const uint64_t finite =
        wide_down(root, 1) + ((uint32_t)root & wide_nonzero(rest)) + soft64_up((exponent - SOFT64_BIAS - 4) >> 1);

    const uint32_t is_zero = soft64_is_zero(x);
    const uint64_t magnitude = wide_select(is_zero | soft64_is_special(x), x, finite);
    return wide_select(wide_high(a) & ~is_zero, SOFT64_NAN, magnitude | (a & SOFT64_SIGN));
}

/* The comparisons give 1 or 0; with a NaN all but soft64_is_unordered give 0. */

/* 1 where a < b as integers with a sign. */
static inline uint32_t soft64_is_less_integer(const uint64_t a, const uint64_t b)
{
    return wide_high((a & ~b) | (~(a ^ b) & (a - b))) >> 31;
}

/* Integers in the order of the numbers; both zeros are 0. */
static inline uint64_t soft64_order(const uint64_t a)
{
    const uint64_t mask = wide_mask(wide_high(a));
    return ((a & SOFT64_MAGNITUDE) ^ mask) - mask;
}

static inline uint32_t soft64_is_unordered(const uint64_t a, const uint64_t b)
{
    return (soft64_is_nan(a & SOFT64_MAGNITUDE) | soft64_is_nan(b & SOFT64_MAGNITUDE)) >> 31;
}

static inline uint32_t soft64_is_less(const uint64_t a, const uint64_t b)
{
    return soft64_is_less_integer(soft64_order(a), soft64_order(b)) & ~soft64_is_unordered(a, b);
}

static inline uint32_t soft64_is_equal(const uint64_t a, const uint64_t b)
{
    return ~(wide_nonzero(soft64_order(a) - soft64_order(b)) | soft64_is_unordered(a, b)) & 1;
}

static inline uint32_t soft64_is_at_most(const uint64_t a, const uint64_t b)
{
    return ~(soft64_is_less_integer(soft64_order(b), soft64_order(a)) | soft64_is_unordered(a, b)) & 1;
}

static inline uint64_t soft64_from_uint64(const uint64_t n)
{
    const uint32_t zeros = wide_zeros(n);
    const uint64_t significand = wide_left(n, zeros);
    return soft64_rounded_top(significand, (SOFT64_BIAS + 63 - zeros) & soft_mask(wide_high(significand)));
}

static inline uint64_t soft64_from_int64(const uint64_t n)
{
    const uint64_t mask = wide_mask(wide_high(n));
    return soft64_from_uint64((n ^ mask) - mask) | (n & SOFT64_SIGN);
}

static inline uint64_t soft64_from_uint32(const uint32_t n)
{
    return soft64_from_uint64(n);
}

static inline uint64_t soft64_from_int32(const uint32_t n)
{
    return soft64_from_int64(wide_of(soft_mask(n), n));
}

/* The magnitude of a as an integer; all ones where it has more than 64 bits, 0 of a NaN. */
static inline uint64_t soft64_to_natural(const uint64_t a)
{
    const uint64_t x = a & SOFT64_MAGNITUDE;
    const uint32_t places =
        SOFT64_BIAS + 64 - soft64_down(x); /* to the right, of bit 63; negative where it is beyond */
    const uint64_t all = wide_right(wide_up(x, SOFT64_ABOVE) | SOFT64_SIGN, wide_count(places)) | wide_mask(places);
    return all & ~wide_mask(soft64_is_nan(x));
}

static inline uint32_t soft64_to_uint32(const uint64_t a)
{
    return soft_uint32_of(soft64_to_natural(a), wide_high(a));
}

static inline uint32_t soft64_to_int32(const uint64_t a)
{
    return soft_int32_of(soft64_to_natural(a), wide_high(a));
}

static inline uint64_t soft64_to_uint64(const uint64_t a)
{
    return soft_uint64_of(soft64_to_natural(a), wide_high(a));
}

static inline uint64_t soft64_to_int64(const uint64_t a)
{
    return soft_int64_of(soft64_to_natural(a), wide_high(a));
}

/* A number of binary32, exact. */
static inline uint64_t soft64_from_binary32(const uint32_t a)
{
    const uint32_t x = a & SOFT_MAGNITUDE;
    uint32_t significand;
    const uint32_t exponent = soft_normalised(x, &significand) + (SOFT64_BIAS - SOFT_BIAS);
    const uint64_t finite =
        wide_of(significand >> SOFT64_ABOVE, significand << (32 - SOFT64_ABOVE)) + soft64_up(exponent);
    const uint64_t special = wide_of(x >> 3, x << 29) | SOFT64_INFINITY;
    const uint64_t number = wide_select(soft_is_special(x), special, finite);
    return wide_select(x - 1, 0, number) | wide_of(a & SOFT_SIGN, 0);
}

/* The nearest number of binary32. Far beyond its range any exponent will do. */
static inline uint32_t soft64_to_binary32(const uint64_t a)
{
    enum { LEAST = 200, MOST = 300 };
    const uint64_t x = a & SOFT64_MAGNITUDE;
    const uint64_t bits = wide_up(x, SOFT64_ABOVE) | SOFT64_SIGN;
    const uint32_t exponent = soft_positive(soft64_down(x) - 1 - (SOFT64_BIAS - SOFT_BIAS) + LEAST) - LEAST;
    const uint32_t limited = MOST - soft_positive(MOST - exponent);
    const uint32_t number = soft_packed(wide_high(bits) | soft_nonzero((uint32_t)bits), 1, limited);
    return soft_select(soft64_is_nan(x), SOFT_NAN, number) | (wide_high(a) & SOFT_SIGN);
}

#endif
