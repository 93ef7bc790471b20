/* Arithmetic of IEEE 754 binary32 on the bits of numbers, without a branch: round to nearest with ties to even, numbers
 * below the least normal one exact. An operation takes the same instructions whatever its operands are.
 *
 * Where an operand is a NaN, or the result is no number, the result is a NaN; which one, and its sign, is not promised.
 *
 * A magnitude is the bits of a number without its sign. An exponent is here less by 1 than the field of the number: 0
 * for the least normal numbers and for those below, so that a significand with its top bit, added to it, gives the
 * number. */
#ifndef ISO_PORT_SOFT_BINARY32_H
#define ISO_PORT_SOFT_BINARY32_H

#include <stdint.h>

#include "port/soft/shifts.h"

#define SOFT_SIGN UINT32_C(0x80000000)
#define SOFT_MAGNITUDE UINT32_C(0x7FFFFFFF)
#define SOFT_INFINITY UINT32_C(0x7F800000)
#define SOFT_NAN UINT32_C(0x7FC00000)

/* The exponent of 1, and the places of the significand behind its top bit. */
enum { SOFT_BIAS = 126, SOFT_FRACTION = 23 };

/* Has the sign bit set where the magnitude x is infinity or a NaN. */
static inline uint32_t soft_is_special(const uint32_t x)
{
    return x + (SOFT_SIGN - SOFT_INFINITY);
}

/* x, or infinity where it is beyond. */
static inline uint32_t soft_limited(const uint32_t x)
{
    const uint32_t excess = x - SOFT_INFINITY;
    return SOFT_INFINITY + (excess & soft_mask(excess));
}

/* The magnitude with a significand of which the top bit is bit 30 + is_high. Its lowest bit shows whether any lower bit
 * was set. The exponent may be negative, or beyond infinity by up to 128. */
static inline uint32_t soft_packed(const uint32_t significand, const uint32_t is_high, const uint32_t exponent)
{
    const uint32_t positive = soft_positive(exponent);
    const uint32_t count = 30 - SOFT_FRACTION + is_high + (positive - exponent);
    const uint32_t x = soft_right(significand, count);
    return soft_limited(soft_rounded(x, soft_left(significand, 32 - count), positive));
}

/* The sum. The smaller magnitude y is shifted to the exponent of the larger, x. */
static inline uint32_t soft_add(uint32_t a, uint32_t b)
{
    /* Both change places where the first is the smaller. */
    const uint32_t difference = a ^ b;
    const uint32_t change = difference & soft_mask((a & SOFT_MAGNITUDE) - (b & SOFT_MAGNITUDE));
    a ^= change;
    b ^= change;
    const uint32_t x = a & SOFT_MAGNITUDE, y = b & SOFT_MAGNITUDE;

    /* Significands with the top bit 29; the lowest bit of the shifted one shows whether any bit was lost. */
    const uint32_t x_exponent = soft_upper(x), y_exponent = soft_upper(y);
    const uint32_t high = (x - soft_up(x_exponent)) << 6;
    const uint32_t low = (y - soft_up(y_exponent)) << 6;
    const uint32_t count = x_exponent - y_exponent;
    const uint32_t kept = soft_right(low, count);
    const uint32_t shifted = kept | (soft_left(kept, count) - low) >> 31;
    const uint32_t sum = high + (shifted ^ soft_mask(difference)) + (difference >> 31);

    /* The top bit of the sum goes to bit 31, as far as the exponent lets it. */
    const uint32_t is_zero = (sum - 1) >> 31;
    const uint32_t target = x_exponent + 2;
    const uint32_t exponent = soft_positive(target - soft_zeros(sum) - (is_zero << 8));
    const uint32_t significand = soft_left(sum, target - exponent);
    const uint32_t finite = soft_limited(soft_rounded(significand >> 8, significand << 24, exponent));

    /* An infinity or a NaN is the result, but for infinity less infinity. A sum of zero is +0, but for -0 - 0. */
    const uint32_t magnitude = soft_select(soft_is_special(x), x | soft_up(is_zero) >> 1, finite);
    return magnitude | (a & ~(difference & is_zero << 31) & SOFT_SIGN);
}

static inline uint32_t soft_subtract(const uint32_t a, const uint32_t b)
{
    return soft_add(a, b ^ SOFT_SIGN);
}

/* The upper half of a product of numbers of which the low 8 bits are zero; the lowest bit shows whether any lower bit
 * was set. */
static inline uint32_t soft_upper_product(const uint32_t a, const uint32_t b)
{
#ifdef SOFT_PIECES
    const uint32_t a_high = a >> 24, a_low = a >> 8 & 0xFFFF;
    const uint32_t b_high = b >> 24, b_low = b >> 8 & 0xFFFF;
    const uint32_t low = a_low * b_low;
    return (a_high * (b >> 8) + a_low * b_high + (low >> 16)) | ((low & 0xFFFF) + 0xFFFF) >> 16;
#else
    const uint64_t product = (uint64_t)a * b;
    return (uint32_t)(product >> 32) | soft_nonzero((uint32_t)product);
#endif
}

/* Puts the top bit of the significand of y, at bit 31, into *significand. Returns its exponent, negative for numbers
 * below the least normal one. */
static inline uint32_t soft_normalised(const uint32_t y, uint32_t *const significand)
{
    const uint32_t exponent = soft_upper(y);
    const uint32_t bits = (y - soft_up(exponent)) << 8;
    const uint32_t zeros = soft_zeros(bits);
    *significand = soft_left(bits, zeros);
    return exponent - zeros;
}

/* The product. Where the larger magnitude x is below the least normal number too, the result is 0 whatever its
 * significand. */
static inline uint32_t soft_multiply(const uint32_t a, const uint32_t b)
{
    const uint32_t difference = a ^ b;
    uint32_t x = a & SOFT_MAGNITUDE, y = b & SOFT_MAGNITUDE;
    const uint32_t change = (x ^ y) & soft_mask(x - y);
    x ^= change;
    y ^= change;

    uint32_t significand;
    const uint32_t is_zero = (y - 1) >> 31; /* then the exponent becomes less than any */
    const uint32_t exponent = soft_down(x) + soft_normalised(y, &significand) - (is_zero << 16);
    const uint32_t product = soft_upper_product(x << 8 | SOFT_SIGN, significand);
    const uint32_t is_high = product >> 31;
    const uint32_t finite = soft_packed(product, is_high, exponent + is_high - (SOFT_BIAS + 1));

    /* An infinity or a NaN is the result, but for infinity times zero. */
    const uint32_t magnitude = soft_select(soft_is_special(x), x | soft_up(is_zero) >> 1, finite);
    return magnitude | (difference & SOFT_SIGN);
}

/* The quotient, a bit at a time. */
static inline uint32_t soft_divide(const uint32_t a, const uint32_t b)
{
    const uint32_t x = a & SOFT_MAGNITUDE, y = b & SOFT_MAGNITUDE;
    uint32_t rest, divisor;
    const uint32_t x_exponent = soft_normalised(x, &rest), y_exponent = soft_normalised(y, &divisor);
    uint32_t quotient = 0;
    rest >>= 8;
    divisor >>= 8;
    for (int bit = 0; bit < 26; bit++) {
        const uint32_t less = rest - divisor;
        const uint32_t is_below = soft_mask(less);
        rest = (less + (divisor & is_below)) << 1;
        quotient = (quotient << 1) + 1 + is_below;
    }
    /* The top bit of the quotient is bit 25 or 24, of the significand 31 or 30. */
    const uint32_t significand = quotient << 6 | soft_nonzero(rest);
    const uint32_t is_high = significand >> 31;
    const uint32_t finite = soft_packed(significand, is_high, x_exponent - y_exponent + is_high + (SOFT_BIAS - 1));

    /* Operands that are zero, infinite or NaN: 0 / y and x / infinity are 0, x / 0 and infinity / y infinite; 0 / 0,
     * infinity / infinity and quotients with a NaN are NaN. */
    const uint32_t x_zero = x - 1, y_zero = y - 1;
    const uint32_t x_special = soft_is_special(x), y_special = soft_is_special(y);
    const uint32_t none = (x_zero & y_zero) | (x_special & y_special) | (SOFT_INFINITY - x) | (SOFT_INFINITY - y);
    const uint32_t limited = soft_select(x_zero | y_special, 0, soft_select(y_zero | x_special, SOFT_INFINITY, finite));
    return soft_select(none, SOFT_NAN, limited) | ((a ^ b) & SOFT_SIGN);
}

/* The square root, a bit at a time: the square of the root so far is subtracted. */
static inline uint32_t soft_root(const uint32_t a)
{
    const uint32_t x = a & SOFT_MAGNITUDE;
    uint32_t significand;
    const uint32_t exponent = soft_normalised(x, &significand) + 2 * (SOFT_BIAS + 2);
    uint32_t rest = soft_left(significand >> 7, exponent & 1);
    uint32_t root = 0;
    for (uint32_t bit = UINT32_C(1) << (SOFT_FRACTION + 1); bit != 0; bit >>= 1) {
        const uint32_t square = (root << 1) + bit;
        const uint32_t less = rest - square;
        const uint32_t is_below = soft_mask(less);
        rest = (less + (square & is_below)) << 1;
        root += bit & ~is_below;
    }
    /* One bit more than the significand has, and no root lies halfway between two numbers. */
    const uint32_t finite = (root >> 1) + (root & soft_nonzero(rest)) + soft_up((exponent - SOFT_BIAS - 4) >> 1);

    const uint32_t is_zero = x - 1;
    const uint32_t magnitude = soft_select(is_zero | soft_is_special(x), x, finite);
    return soft_select(a & ~is_zero, SOFT_NAN, magnitude | (a & SOFT_SIGN));
}

/* The comparisons give 1 or 0; with a NaN all but soft_is_unordered give 0. */

/* 1 where a < b as integers with a sign. */
static inline uint32_t soft_is_less_integer(const uint32_t a, const uint32_t b)
{
    return ((a & ~b) | (~(a ^ b) & (a - b))) >> 31;
}

/* Integers in the order of the numbers; both zeros are 0. */
static inline uint32_t soft_order(const uint32_t a)
{
    const uint32_t mask = soft_mask(a);
    return ((a & SOFT_MAGNITUDE) ^ mask) - mask;
}

static inline uint32_t soft_is_unordered(const uint32_t a, const uint32_t b)
{
    return ((SOFT_INFINITY - (a & SOFT_MAGNITUDE)) | (SOFT_INFINITY - (b & SOFT_MAGNITUDE))) >> 31;
}

static inline uint32_t soft_is_less(const uint32_t a, const uint32_t b)
{
    return soft_is_less_integer(soft_order(a), soft_order(b)) & ~soft_is_unordered(a, b);
}

static inline uint32_t soft_is_equal(const uint32_t a, const uint32_t b)
{
    return ~(soft_nonzero(soft_order(a) - soft_order(b)) | soft_is_unordered(a, b)) & 1;
}

static inline uint32_t soft_is_at_most(const uint32_t a, const uint32_t b)
{
    return ~(soft_is_less_integer(soft_order(b), soft_order(a)) | soft_is_unordered(a, b)) & 1;
}

/* The magnitude of high * 2^32 + low. */
static inline uint32_t soft_from_natural(const uint32_t high, const uint32_t low)
{
    /* The top bit goes to bit 31 of the significand: by 32 places, and by those that are left. */
    const uint32_t is_short = ((high >> 1 | (high & 1)) - 1) >> 31;
    const uint32_t upper = high | (low & (0 - is_short)), lower = low & (is_short - 1);
    const uint32_t zeros = soft_zeros(upper);
    const uint32_t behind = soft_left(lower, zeros);
    const uint32_t significand = soft_left(upper, zeros) | soft_right(lower, 32 - zeros) | soft_nonzero(behind);
    const uint32_t exponent = (SOFT_BIAS + 63 - (is_short << 5) - zeros) & soft_mask(significand);
    return soft_rounded(significand >> 8, significand << 24, exponent);
}

static inline uint32_t soft_from_uint32(const uint32_t n)
{
    return soft_from_natural(0, n);
}

static inline uint32_t soft_from_int32(const uint32_t n)
{
    const uint32_t mask = soft_mask(n);
    return soft_from_natural(0, (n ^ mask) - mask) | (n & SOFT_SIGN);
}

static inline uint32_t soft_from_uint64(const uint64_t n)
{
    return soft_from_natural((uint32_t)(n >> 32), (uint32_t)n);
}

static inline uint32_t soft_from_int64(const uint64_t n)
{
    const uint32_t high = (uint32_t)(n >> 32);
    const uint64_t mask = (uint64_t)soft_mask(high) << 32 | soft_mask(high);
    return soft_from_uint64((n ^ mask) - mask) | (high & SOFT_SIGN);
}

/* Integers are those towards zero; of a number beyond their range the last one, and of a NaN 0. */

/* The magnitude of a as an integer; all ones where it has more than 64 bits, 0 of a NaN. */
static inline uint64_t soft_to_natural(const uint32_t a)
{
    const uint32_t x = a & SOFT_MAGNITUDE;
    const uint32_t significand = x << 8 | SOFT_SIGN;
    const uint32_t places = soft_down(x) - (SOFT_BIAS + 32); /* to the left, of bit 31 in 64 bits */
    const uint32_t beyond = soft_mask(32 - places) & ~soft_mask(places);
    const uint32_t high = soft_right(significand, 32 - places) | beyond;
    const uint32_t low = soft_left(significand, places) | soft_right(significand, 0 - places) | beyond;
    const uint32_t number = ~soft_mask(SOFT_INFINITY - x);
    return (uint64_t)(high & number) << 32 | (low & number);
}

/* An integer of a magnitude and of the sign bit of `sign`. */

static inline uint32_t soft_uint32_of(const uint64_t natural, const uint32_t sign)
{
    const uint32_t beyond = 0 - soft_nonzero((uint32_t)(natural >> 32));
    return ((uint32_t)natural | beyond) & ~soft_mask(sign);
}

static inline uint32_t soft_int32_of(const uint64_t natural, const uint32_t sign)
{
    const uint32_t all = (uint32_t)natural | (0 - soft_nonzero((uint32_t)(natural >> 32)));
    const uint32_t mask = soft_mask(sign);
    return (soft_select(all, SOFT_MAGNITUDE + (sign >> 31), all) ^ mask) - mask;
}

static inline uint64_t soft_uint64_of(const uint64_t natural, const uint32_t sign)
{
    const uint32_t positive = ~soft_mask(sign);
    return natural & ((uint64_t)positive << 32 | positive);
}

static inline uint64_t soft_int64_of(const uint64_t natural, const uint32_t sign)
{
    const uint32_t is_beyond = soft_mask((uint32_t)(natural >> 32));
    const uint64_t beyond = (uint64_t)is_beyond << 32 | is_beyond;
    const uint64_t mask = (uint64_t)soft_mask(sign) << 32 | soft_mask(sign);
    const uint64_t last = (uint64_t)INT64_MAX + (sign >> 31);
    return (((natural & ~beyond) | (last & beyond)) ^ mask) - mask;
}

static inline uint32_t soft_to_uint32(const uint32_t a)
{
    return soft_uint32_of(soft_to_natural(a), a);
}

static inline uint32_t soft_to_int32(const uint32_t a)
{
    return soft_int32_of(soft_to_natural(a), a);
}

static inline uint64_t soft_to_uint64(const uint32_t a)
{
    return soft_uint64_of(soft_to_natural(a), a);
}

static inline uint64_t soft_to_int64(const uint32_t a)
{
    return soft_int64_of(soft_to_natural(a), a);
}

#endif
