/* Gaussian noise as a function of the tick: the same number for the same tick and seed on every machine, in any order, and
 * without a state.
 *
 * Mean 0 (within 1e-8) and variance 1 exactly, if the bits of the hash were random; excess kurtosis -0.084; at most 5.5 in
 * size (tests/exhaustive/noise.c). Numbers of different ticks, and of different seeds, are uncorrelated.
 *
 * Hash of 32 bits: Wellons (2018), Prospecting for hash functions, lowbias32; with the seed between its two rounds, so that
 * no seed gives the sequence of another later. Its 16 pairs of bits are 16 uniform numbers from 0 to 3, whose sum is nearly
 * Gaussian, 24 +- 4.5 (central limit theorem). A uniform number from the upper half of the last product fills the space
 * from one sum to the next.
 */
#ifndef ISO_CORE_NUMBERS_NOISE_H
#define ISO_CORE_NUMBERS_NOISE_H

#include "core/numbers/real.h"

/* The sum of the pairs of bits in units of 2^24: of two pairs, of four, and of all by a product, in whose lower bytes are
 * sums of fewer. So the bytes of four pairs count 1, 1 + 2^-8, 1 + 2^-8 + 2^-16 and 1 + 2^-8 + 2^-16 + 2^-24. */
static inline uint32_t iso_sum_of_pairs(const uint32_t bits)
{
    const uint32_t twos = (bits & UINT32_C(0x33333333)) + ((bits >> 2) & UINT32_C(0x33333333));
    const uint32_t fours = (twos + (twos >> 4)) & UINT32_C(0x0F0F0F0F);
    return fours * UINT32_C(0x01010101);
}

/* The high half of the tick stands beside the seed: after 2^32 ticks another sequence begins, and not the first again. */
static inline real iso_noise(const uint64_t tick, const uint32_t seed)
{
    const uint32_t low = (uint32_t)tick, high = (uint32_t)(tick >> 32);
    uint32_t h = low ^ (low >> 16);
    h = h * UINT32_C(0x7FEB352D) + seed * UINT32_C(0x9E3779B9) + high * UINT32_C(0x85EBCA77);
    const uint64_t product = (uint64_t)(h ^ (h >> 15)) * UINT32_C(0x846CA68B);
    const uint32_t hash = (uint32_t)product ^ ((uint32_t)product >> 16), between = (uint32_t)(product >> 32) & 0xFFFFFF;
    /* Means: 6 for each byte, and 2^23. Variances: 5 for each byte, and 2^48 / 12. */
    const int32_t sum = (int32_t)(iso_sum_of_pairs(hash) + between) - 412224518;
    return (real)sum * R(1.3261512544296112e-08); /* 1 / sqrt of the variance */
}

#endif
