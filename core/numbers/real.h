/* The number type of a build, and the bits of a number.
 *
 * `real` is float, or double with -DISO_REAL_DOUBLE. Literals are written R(0.5). Every function here is free of
 * branches and of libm: a comparison gives a mask, and a mask selects. A number in a table is an `iso_scalar`, written
 * ISO_SCALAR(0.5). Both are one type, but for plants side by side (core/numbers/lanes.h).
 */
#ifndef ISO_CORE_NUMBERS_REAL_H
#define ISO_CORE_NUMBERS_REAL_H

#include <float.h>
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Settings that change bits and that the preprocessor sees are errors. The macros of gcc for its flags are read before
 * the pragma below, since gcc up to version 11 undefines them there. */
#ifdef __NO_MATH_ERRNO__
#define ISO_HAS_NO_MATH_ERRNO
#endif
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ ||                            \
    defined __NO_SIGNED_ZEROS__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error "Isochron: -ffast-math and its parts change results; compile without them and without -Ofast"
#endif

/* Others are corrected for the code that follows, as far as the compiler allows; this costs no instruction: gcc fuses
 * products with sums by default, and its vectoriser does so whatever its options (GCC PR 106902); clang may fuse within
 * an expression, and has no macro for sums in another order and division by a reciprocal. A clang that does not know
 * one of these pragmas for its target ignores it. core/numbers/self_check.h finds the rest. */
#if defined __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma clang diagnostic ignored "-Wunknown-pragmas"
#pragma float_control(precise, on)
#if __clang_major__ >= 13
#pragma clang fp reassociate(off)
#endif
#if __clang_major__ >= 18
#pragma clang fp reciprocal(off)
#endif
#pragma STDC FP_CONTRACT OFF
#pragma clang diagnostic pop
#elif !defined __GNUC__
#pragma STDC FP_CONTRACT OFF
#elif __GNUC__ > 5
#pragma GCC optimize("fp-contract=off", "no-tree-vectorize", "no-tree-slp-vectorize")
#endif

/* 16 and 32 widen only what is narrower than float: a gcc that computes in half precision, as for a Cortex-M55, says 16
 * (ISO/IEC TS 18661-3:2015, 8). */
#if FLT_EVAL_METHOD == 1
#error "Isochron: float is computed in double (FLT_EVAL_METHOD is 1), as on s390x; compile with -fexcess-precision=fast"
#elif FLT_EVAL_METHOD == 2
#error "Isochron: float is computed in long double (FLT_EVAL_METHOD is 2), as on x87; use -msse2 -mfpmath=sse"
#elif FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 && FLT_EVAL_METHOD != 32
#error                                                                                                                 \
    "Isochron: the type in which float is computed is not known (FLT_EVAL_METHOD); compile with flags for which it is 0"
#endif
#if CHAR_BIT != 8 || FLT_RADIX != 2 || FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128 || FLT_MIN_EXP != -125
#error "Isochron: bytes of 8 bits and float of IEEE 754 binary32 are needed"
#endif
#if defined ISO_REAL_DOUBLE && (DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024 || DBL_MIN_EXP != -1021)
#error "Isochron: double is not IEEE 754 binary64; compile with double of 64 bits, or for float"
#endif
#ifdef ISO_REAL_DOUBLE
extern char iso_compile_without_fsingle_precision_constant[sizeof(1.0) == sizeof(double) ? 1 : -1];
#endif
#if defined FLT_HAS_SUBNORM && FLT_HAS_SUBNORM == 0
#error "Isochron: numbers near zero are flushed to it; compile with denormals kept"
#endif

#ifdef ISO_REAL_DOUBLE

typedef double iso_scalar;
typedef uint64_t iso_word; /* as wide as a scalar */
#define ISO_SCALAR(literal) literal
#define ISO_REAL_NAME(name) ISO_REAL_NAMED(name, double) /* objects of different real do not link */

#define ISO_REAL_BITS 64 /* what `real` is from here on, whatever is defined later: each plant's header asks */
enum { ISO_SIGN_SHIFT = 63, ISO_EXPONENT_SHIFT = 52 };
#define ISO_EXPONENT_BITS UINT64_C(0x7FF0000000000000)
#define ISO_REAL_MAX DBL_MAX
#define ISO_REAL_LEAST DBL_MIN
#define ISO_REAL_EPSILON DBL_EPSILON /* distance from 1 to the next real: one ulp of 1.0 */
#define ISO_ROUNDER                                                                                                    \
    ISO_SCALAR(6755399441055744.0) /* 1.5 * 2^52: adding it rounds to a whole number, then in the low bits */

#else

typedef float iso_scalar;
typedef uint32_t iso_word;
#define ISO_SCALAR(literal) literal##f
#define ISO_REAL_NAME(name) ISO_REAL_NAMED(name, float)

#define ISO_REAL_BITS 32
enum { ISO_SIGN_SHIFT = 31, ISO_EXPONENT_SHIFT = 23 };
#define ISO_EXPONENT_BITS UINT32_C(0x7F800000)
#define ISO_REAL_MAX FLT_MAX
#define ISO_REAL_LEAST FLT_MIN
#define ISO_REAL_EPSILON FLT_EPSILON
#define ISO_ROUNDER ISO_SCALAR(12582912.0)

#endif

#define ISO_SIGN_BIT ((iso_word)1 << ISO_SIGN_SHIFT)

#ifdef ISO_LANES
#include "core/numbers/lanes.h"
#else

#define ISO_REAL_NAMED(name, type) name##_##type

typedef iso_scalar real;
typedef iso_word iso_bits; /* as wide as a real; and a mask: all ones or zero */
typedef bool iso_flag;     /* a truth value of a plant */
typedef uint32_t iso_count;
typedef uint8_t iso_steps; /* a count of a few steps; behind it and a flag `iso_rest` fills up a real */
typedef uint8_t iso_rest[sizeof(real) - 2];
typedef int32_t iso_turns; /* whole turns, modulo 2^32 */
typedef uint64_t iso_pair; /* two counts, the second in the upper half */
#define R(literal) ISO_SCALAR(literal)
#define ISO_COUNT(count) count

/* A number of a table, as a real. */
static inline real iso_all(const iso_scalar x)
{
    return x;
}

/* Whether a mask, or a flag, is set. */
static inline bool iso_any(const iso_bits mask)
{
    return mask != 0;
}

/* A mask, unchanged. From clang, which on x86 makes a branch of a value that it knows to be one of two, an empty
 * statement hides that all bits of it are equal; on the Cortex-M4F it would keep gcc from the cheapest selection. Every
 * mask is made, or selects, through it. */
static inline iso_bits iso_hidden(iso_bits mask)
{
#ifdef __clang__
    __asm__("" : "+r"(mask));
#endif
    return mask;
}

/* All ones where a condition holds. */
static inline iso_bits iso_mask_where(const bool condition)
{
    return (iso_bits)0 - condition;
}

#define ISO_NOTHING 0 /* zero bits */

/* x[n] = numbers[n] of a table. */
static inline void iso_spread(real *const x, const iso_scalar *const numbers, const uint16_t n)
{
    memcpy(x, numbers, n * sizeof *x);
}

/* Whether a > b; and whether bits are not zero. */
static inline iso_flag iso_is_larger(const real a, const real b)
{
    return a > b;
}

static inline iso_flag iso_is_set(const iso_bits bits)
{
    return bits != 0;
}

/* A count with one more, unless a flag is set. */
static inline iso_count iso_more_unless(const iso_flag flag, const iso_count count)
{
    return count + !flag;
}

/* A count, where this mask is set, as it is here. */
static inline iso_count iso_count_where(const iso_bits mask, const uint32_t count)
{
    (void)mask;
    return count;
}

static inline iso_pair iso_pair_of(const iso_count first, const iso_count second)
{
    return first | (iso_pair)second << 32;
}

/* A pair with more in its second count. */
static inline iso_pair iso_pair_more(const iso_pair pair, const iso_count second)
{
    return pair + ((iso_pair)second << 32);
}

/* x[n] = good[n], where this mask is set, as it is here. */
static inline void iso_hold(real *const x, real *const good, const uint32_t n, const iso_bits mask)
{
    (void)mask;
    memcpy(x, good, n * sizeof *x);
}

/* Whole numbers of 32 bits, with a sign, as reals: turns, and the low bits of others. */
static inline real iso_real_of_turns(const iso_turns turns)
{
    return (real)turns;
}

static inline real iso_real_of_whole(const iso_bits whole)
{
    return (real)(int32_t)(uint32_t)whole;
}

#endif

/* A whole number as a real. */
static inline real iso_whole(const int32_t n)
{
    return iso_all((iso_scalar)n);
}

/* The bits of x, and the real that has the bits b. */
static inline iso_bits iso_bits_of(const real x)
{
    iso_bits b;
    memcpy(&b, &x, sizeof b);
    return b;
}

static inline real iso_real_of(const iso_bits b)
{
    real x;
    memcpy(&x, &b, sizeof x);
    return x;
}

/* All ones where the sign bit of b is set, else zero; and the same of its lowest bit. */
static inline iso_bits iso_mask_of_sign(const iso_bits b)
{
    return iso_hidden(0 - (b >> ISO_SIGN_SHIFT));
}

static inline iso_bits iso_mask_of_lowest(const iso_bits b)
{
    return iso_hidden(0 - (b & 1));
}

/* All ones if a < b, else zero; for a and b that are not NaN and not the same infinity; -0 is below 0. The sign of
 * a - b is exact with denormals kept: a - b is zero only for a = b. */
static inline iso_bits iso_less(const real a, const real b)
{
    return iso_mask_of_sign(iso_bits_of(a - b));
}

/* a where the mask is all ones, b where it is zero. */
static inline real iso_select(const iso_bits mask, const real a, const real b)
{
    const iso_bits hidden = iso_hidden(mask);
    return iso_real_of((iso_bits_of(a) & hidden) | (iso_bits_of(b) & ~hidden));
}

static inline real iso_min(const real a, const real b)
{
    return iso_select(iso_less(b, a), b, a);
}

static inline real iso_max(const real a, const real b)
{
    return iso_select(iso_less(a, b), b, a);
}

/* x where it is above 0, else +0: the larger of both. */
static inline real iso_positive(const real x)
{
    return iso_real_of(iso_bits_of(x) & ~iso_mask_of_sign(iso_bits_of(x)));
}

/* x where it is below 0, also where it is -0, else +0: the smaller of both. On the Cortex-M4F an instruction less. */
static inline real iso_negative(const real x)
{
    return iso_real_of(iso_bits_of(x) & iso_mask_of_sign(iso_bits_of(x)));
}

/* 1 if a > b, else 0; for a and b that are not NaN and not the same infinity. The zeros are equal: d & (d - 1) has the
 * sign of d, but for -0. */
static inline real iso_above(const real a, const real b)
{
    const iso_bits d = iso_bits_of(b - a);
    return iso_real_of(iso_mask_of_sign(d & (d - 1)) & iso_bits_of(R(1.0)));
}

/* x limited to [low, high], for low <= high. */
static inline real iso_clamp(const real x, const real low, const real high)
{
    return iso_min(iso_max(x, low), high);
}

/* x with its size limited to most > 0; a NaN counts as an infinity. The bits of reals are in the order of their sizes:
 * the excess of those of x over those of `most` is subtracted. */
static inline real iso_limited(const real x, const real most)
{
    const iso_bits excess = (iso_bits_of(x) & ~ISO_SIGN_BIT) - iso_bits_of(most);
    return iso_real_of(iso_bits_of(x) - (excess & ~iso_mask_of_sign(excess)));
}

static inline real iso_abs(const real x)
{
    return iso_real_of(iso_bits_of(x) & ~ISO_SIGN_BIT);
}

/* Integers, modulo 2^32 or 2^64, in the order of the reals: that of -0 is one less than that of +0, which is 0. */
static inline iso_bits iso_order(const real x)
{
    return iso_bits_of(x) ^ (iso_mask_of_sign(iso_bits_of(x)) >> 1);
}

/* All ones if x is an infinity or a NaN, else zero: an exponent of all ones plus one carries into the sign. */
static inline iso_bits iso_not_finite(const real x)
{
    const iso_bits exponent = iso_bits_of(x) & ISO_EXPONENT_BITS;
    const iso_word lowest = ISO_EXPONENT_BITS & (~ISO_EXPONENT_BITS + 1);
    return iso_mask_of_sign(exponent + lowest);
}

/* All ones if |x| is beyond range > 0, finite, or if x is no number, else zero: without their sign, the bits of reals
 * are in the order of their sizes, and those of an infinity or a NaN above all. */
static inline iso_bits iso_beyond(const real x, const real range)
{
    return iso_mask_of_sign(iso_bits_of(range) - (iso_bits_of(x) & ~ISO_SIGN_BIT));
}

#endif
