/* Gaussian noise as a function of the tick: the same number for the same tick and seed on every machine, in any order,
 * and without a state.
 *
 * Over the 2^32 ticks of a high half the hash takes each value once. So for every seed the mean is 0 and the variance 1
 * (but for 1e-8, and the rounding of the factor), the excess kurtosis -0.0843, and the size at most 5.5
 * (tests/core/numbers/exhaustive/noise.c). Indistinguishable from independent numbers
 * (tests/core/numbers/exhaustive/white.c): the spectra of the numbers and of their squares, also of every n-th tick,
 * pairs up to 64 ticks apart, of two seeds, and of two high halves, the coherence and the correlation at lags up to
 * 2^14 ticks.
 *
 * The hash is triple32 (Wellons, 2018, Prospecting for hash functions): three rounds of a shift and a product. With two
 * (lowbias32 there) the spectrum of the squares has lines. The seed makes two keys, which the compiler computes, as
 * seeds are constants: one is added to the tick, the other behind the first product, so that no seed has the sequence
 * of another later. The 16 pairs of bits of the hash are 16 uniform numbers from 0 to 3, whose sum is nearly Gaussian,
 * 24 +- 4.5 (central limit theorem). A uniform number from a further product fills the space from one sum to the next.
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

/* A bijection of x, by triple32, with a key behind its first product. */
static inline uint32_t iso_noise_hash(uint32_t x, const uint32_t key)
{
    x = (x ^ (x >> 17)) * UINT32_C(0xED5AD4BB) + key;
    x = (x ^ (x >> 11)) * UINT32_C(0xAC4C1B51);
    x = (x ^ (x >> 15)) * UINT32_C(0x31848BAB);
    return x ^ (x >> 14);
}

/* The mean of a byte of pairs is 6, its variance 5; those of the number between are nearly 2^23 and 2^48 / 12. */
static inline real iso_gaussian(const uint32_t hash)
{
    const uint32_t between = (hash * UINT32_C(0x31848BAB)) >> 8;
    const int32_t sum = (int32_t)(iso_sum_of_pairs(hash) + between) - 412224518;
    return iso_whole(sum) * R(1.3261512544296112e-08); /* 1 / sqrt of the variance */
}

/* The high half of the tick stands beside the seed: after 2^32 ticks another sequence begins, and not the first again.
 */
static inline real iso_noise(const uint64_t tick, const uint32_t seed)
{
    const uint32_t low = (uint32_t)tick, high = (uint32_t)(tick >> 32);
    const uint32_t first = iso_noise_hash(seed, UINT32_C(0x9E3779B9)), second = seed * UINT32_C(0x7FEB352D) + high;
    return iso_gaussian(iso_noise_hash(low + first, second));
}

#endif
