/* Gaussian noise as a function of the tick: the same number for the same tick and seed on every machine, in any order,
 * and without a state.
 *
 * Mean 0 (within 1e-8) and variance 1 exactly, if the bits of the hash were random; excess kurtosis -0.084; at most 5.5
 * in size (tests/exhaustive/noise.c). Indistinguishable from independent numbers (tests/exhaustive/white.c): the
 * spectra of the numbers and of their squares, pairs up to 64 ticks apart, and of two seeds, the coherence and the
 * correlation at lags up to 2^14 ticks.
 *
 * Hash of 32 bits: a cubic polynomial of the tick, which is a bijection, and a round of a shift, a product and a shift.
 * The spectrum of the squares has a line where a multiple of the tick takes the place of the polynomial. The seed makes
 * two keys, within the polynomial and behind it, so that no seed has the sequence of another later: the first by
 * lowbias32 (Wellons, 2018, Prospecting for hash functions), which the compiler computes, as seeds are constants. The
 * 16 pairs of bits of the hash are 16 uniform numbers from 0 to 3, whose sum is nearly Gaussian, 24 +- 4.5 (central
 * limit theorem). A uniform number from the high half of the product, whose factor is near 2^32, fills the space from
 * one sum to the next.
 */
#ifndef ISO_CORE_NUMBERS_NOISE_H
#define ISO_CORE_NUMBERS_NOISE_H

#include "core/numbers/real.h"

/* The sum of the pairs of bits in units of 2^24: of two pairs, of four, and of all by a product, in whose lower bytes
 * are sums of fewer. So the bytes of four pairs count 1, 1 + 2^-8, 1 + 2^-8 + 2^-16 and 1 + 2^-8 + 2^-16 + 2^-24. */
static inline uint32_t iso_sum_of_pairs(const uint32_t bits)
{
    const uint32_t twos = (bits & UINT32_C(0x33333333)) + ((bits >> 2) & UINT32_C(0x33333333));
    const uint32_t fours = (twos + (twos >> 4)) & UINT32_C(0x0F0F0F0F);
    return fours * UINT32_C(0x01010101);
}

/* A key of a seed: a bijection whose values for neighbouring seeds have nothing in common. */
static inline uint32_t iso_noise_key(const uint32_t seed)
{
    uint32_t key = seed + UINT32_C(0x9E3779B9);
    key = (key ^ (key >> 16)) * UINT32_C(0x7FEB352D);
    key = (key ^ (key >> 15)) * UINT32_C(0x846CA68B);
    return key ^ (key >> 16);
}

/* The high half of the tick stands beside the seed: after 2^32 ticks another sequence begins, and not the first again.
 */
static inline real iso_noise(const uint64_t tick, const uint32_t seed)
{
    const uint32_t low = (uint32_t)tick, high = (uint32_t)(tick >> 32), x = low + iso_noise_key(seed);
    const uint32_t h = x * (x * x | 1) + (seed * UINT32_C(0x7FEB352D) + high);
    const uint64_t product = (uint64_t)(h ^ (h >> 15)) * UINT32_C(0xFD7046C5);
    const uint32_t lower = (uint32_t)product, between = (uint32_t)(product >> 40);
    /* Means: 6 for each byte, and 2^23 f with the factor f 2^32. Variances: 5 for each byte, and f^2 2^48 / 12. */
    const int32_t sum = (int32_t)(iso_sum_of_pairs(lower ^ (lower >> 16)) + between) - 412140585;
    return (iso_scalar)sum * R(1.32620572064598e-08); /* 1 / sqrt of the variance */
}

#endif
