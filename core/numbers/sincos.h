/* Sine and cosine without a branch, in + - * and the bits of the result.
 *
 * Domain |x| <= 1e4, error of each at most 1.5 ulp of 1.0 there (tests/core/numbers/exhaustive/sincos.c). Outside of
 * the domain the result is meaningless; for an infinity or a NaN it is NaN. sin(-x) = -sin(x), cos(-x) = cos(x)
 * exactly.
 *
 * Reduction: Cody and Waite (1980), Software Manual for the Elementary Functions, ch. 8: pi in two parts, the first
 * short enough for a whole number of them to be exact. Whole half turns change the sign of both results and nothing
 * else, so that no two results are exchanged. Minimax polynomials on [-pi/2, pi/2] of the absolute error, by Remez's
 * exchange (Muller 2016, Elementary Functions, sec. 3.5).
 */
#ifndef ISO_CORE_NUMBERS_SINCOS_H
#define ISO_CORE_NUMBERS_SINCOS_H

#include "core/numbers/real.h"

typedef struct iso_sine_cosine {
    real sin;
    real cos;
} iso_sine_cosine;

/* The series of both beyond their first terms, of z = r^2 <= (pi/2)^2: in .sin (sin(r) - r) / r^3, in .cos
 * (cos(r) - 1 + z / 2) / z^2. Their terms alternate in the code, because a product waits for the sum before it. */
static inline iso_sine_cosine iso_sincos_tails(real z);

/* The beginnings of the power series of (sin(d) - d) / d^3 in .sin and of (cos(d) - 1 + z / 2) / z^2 in .cos, of z =
 * d^2. */
static inline iso_sine_cosine iso_sincos_beginnings(real z);

/* Sine and cosine of an angle beyond that of `from` by one of which this is the sine, and the cosine less one. */
static inline iso_sine_cosine iso_sincos_turned(const iso_sine_cosine from, const real sine, const real less)
{
    return (iso_sine_cosine){from.sin + (from.sin * less + from.cos * sine),
                             from.cos + (from.cos * less - from.sin * sine)};
}

/* Sine and cosine of an angle that is d beyond that of `from`, where both differ little, as those of two stages at the
 * same time: the series end with the third power in the sine and the fourth in the cosine, in float with the first and
 * the second. Within |d| <= 1.6e-3, in float 0.005, the error is at most 1 ulp of 1.0 more than that of `from`; beyond
 * it grows as |d|^5 / 5!, in float |d|^3 / 3!. */
static inline iso_sine_cosine iso_sincos_close(iso_sine_cosine from, real d);

#ifdef ISO_REAL_DOUBLE

/* The parts of pi. */
#define ISO_PI_1 R(3.1415926534682512)
#define ISO_PI_2 R(1.215420101301238e-10)

/* The error is at most 2.5e-19 in the sine, 5.8e-18 in the cosine. */
static inline iso_sine_cosine iso_sincos_tails(const real z)
{
    real s = R(2.7205059941041787e-15), c = R(4.61610011788302e-14);
    s = s * z - R(7.64292761566721e-13);
    c = c * z - R(1.1463632383580636e-11);
    s = s * z + R(1.6058937287911363e-10);
    c = c * z + R(2.087659248648486e-09);
    s = s * z - R(2.5052106827328184e-08);
    c = c * z - R(2.7557317066658744e-07);
    s = s * z + R(2.75573192107112e-06);
    c = c * z + R(2.480158728576697e-05);
    s = s * z - R(1.9841269841207673e-04);
    c = c * z - R(1.3888888888829974e-03);
    s = s * z + R(8.333333333333196e-03);
    c = c * z + R(4.166666666666583e-02);
    s = s * z - R(1.6666666666666666e-01);
    return (iso_sine_cosine){s, c};
}

static inline iso_sine_cosine iso_sincos_beginnings(const real z)
{
    real s = R(-1.984126984126984e-04), c = R(2.48015873015873e-05);
    s = s * z + R(8.333333333333333e-03);
    c = c * z - R(1.388888888888889e-03);
    s = s * z - R(1.6666666666666666e-01);
    c = c * z + R(4.1666666666666664e-02);
    return (iso_sine_cosine){s, c};
}

static inline iso_sine_cosine iso_sincos_close(const iso_sine_cosine from, const real d)
{
    const real z = d * d;
    const real less = z * (z * R(4.1666666666666664e-02) - R(0.5));
    return iso_sincos_turned(from, d + d * (z * R(-1.6666666666666666e-01)), less);
}

#else

#define ISO_PI_1 R(3.1416015625)
#define ISO_PI_2 R(-8.90891020676e-6)

/* The error is at most 4.9e-9 in the sine, 4.4e-10 in the cosine. */
static inline iso_sine_cosine iso_sincos_tails(const real z)
{
    real s = R(2.598847232e-6), c = R(-2.620901967e-7);
    s = s * z - R(1.980603265e-4);
    c = c * z + R(2.477017915e-5);
    s = s * z + R(8.333008736e-3);
    c = c * z - R(1.388858538e-3);
    s = s * z - R(1.666665673e-1);
    c = c * z + R(4.166665673e-2);
    return (iso_sine_cosine){s, c};
}

static inline iso_sine_cosine iso_sincos_beginnings(const real z)
{
    return (iso_sine_cosine){R(8.333333333e-3) * z - R(1.666666667e-1), R(4.166666667e-2) - R(1.388888889e-3) * z};
}

static inline iso_sine_cosine iso_sincos_close(const iso_sine_cosine from, const real d)
{
    const real half = R(0.5) * d;
    return (iso_sine_cosine){from.sin + d * (from.cos - half * from.sin), from.cos - d * (from.sin + half * from.cos)};
}

#endif

/* x - k pi for a whole number |k| <= 3200 near x / pi. */
static inline real iso_less_half_turns(const real x, const real k)
{
    return (x - k * ISO_PI_1) - k * ISO_PI_2;
}

static inline iso_sine_cosine iso_sincos(const real x)
{
    /* x = k pi + r, |r| <= pi/2 (and a rounding), k in the low bits of the rounded sum. An odd k changes both signs. */
    const real rounded = x * R(0.318309886183790672) + ISO_ROUNDER;
    const real r = iso_less_half_turns(x, rounded - ISO_ROUNDER);
    const iso_bits sign = iso_bits_of(rounded) << ISO_SIGN_SHIFT;

    const real z = r * r;
    const iso_sine_cosine tail = iso_sincos_tails(z);
    const real half = z * tail.cos - R(0.5);
    const real cubic = z * tail.sin;
    const real first = iso_real_of(iso_bits_of(r) ^ sign);
    const iso_sine_cosine result = {first + first * cubic, iso_real_of(iso_bits_of(R(1.0) + z * half) ^ sign)};
    return result;
}

/* The same for larger |d|, by the addition theorem. The series end with the seventh power in the sine and the eighth in
 * the cosine, in float with the fifth and the sixth. Within |d| <= 0.07, in float 0.25, the error is at most 1 ulp of
 * 1.0 more than that of `from`; beyond it grows as |d|^9 / 9!, in float |d|^7 / 7!. */
static inline iso_sine_cosine iso_sincos_beyond(const iso_sine_cosine from, const real d)
{
    const real z = d * d;
    const iso_sine_cosine series = iso_sincos_beginnings(z);
    return iso_sincos_turned(from, d + d * (z * series.sin), z * (z * series.cos - R(0.5)));
}

#endif
