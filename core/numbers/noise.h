/* Gaussian noise as a function of the tick: the same number for the same tick and seed on every machine, in any order, and
 * without a state.
 *
 * Mean 0 and variance 1 exactly, if the bits of the hash were random; excess kurtosis -0.06; at most 5.95 in size
 * (tests/exhaustive/noise.c). Numbers of different ticks, and of different seeds, are uncorrelated.
 *
 * Hash of 32 bits: Wellons (2018), Prospecting for hash functions, lowbias32; with the seed between its two rounds, so that
 * no seed gives the sequence of another later. The number of ones of the hash is binomial, 16 +- 2.8. Two uniform numbers
 * from a product of the hash, 16 bits each, are added: then the density is the binomial one with straight lines between
 * its values. The variance is 32 / 4 + 2 / 12.
 */
#ifndef ISO_CORE_NUMBERS_NOISE_H
#define ISO_CORE_NUMBERS_NOISE_H

#include "core/numbers/real.h"

/* The high half of the tick stands beside the seed: after 2^32 ticks another sequence begins, and not the first again. */
static inline uint32_t iso_hash_of_tick(const uint64_t tick, const uint32_t seed)
{
    const uint32_t low = (uint32_t)tick, high = (uint32_t)(tick >> 32);
    uint32_t h = low ^ (low >> 16);
    h = h * UINT32_C(0x7FEB352D) + seed * UINT32_C(0x9E3779B9) + high * UINT32_C(0x85EBCA77);
    h = (h ^ (h >> 15)) * UINT32_C(0x846CA68B);
    return h ^ (h >> 16);
}

/* How many bits are one: of pairs, of fours, of bytes, of all (Knuth 2009, The Art of Computer Programming 4A, 7.1.3). */
static inline uint32_t iso_ones(const uint32_t bits)
{
    const uint32_t pairs = bits - ((bits >> 1) & UINT32_C(0x55555555));
    const uint32_t fours = (pairs & UINT32_C(0x33333333)) + ((pairs >> 2) & UINT32_C(0x33333333));
    const uint32_t bytes = (fours + (fours >> 4)) & UINT32_C(0x0F0F0F0F);
    return (bytes * UINT32_C(0x01010101)) >> 24;
}

static inline real iso_noise(const uint64_t tick, const uint32_t seed)
{
    const uint32_t hash = iso_hash_of_tick(tick, seed);
    const uint32_t other = (hash ^ (hash >> 13)) * UINT32_C(0xC2B2AE35);
    const uint32_t between = (other & UINT32_C(0xFFFF)) + (other >> 16);
    const int32_t sum = (int32_t)((iso_ones(hash) << 16) + between) - ((17 << 16) - 1);
    return (real)sum * R(5.33946390e-6); /* 2^-16 / sqrt(8 + 1/6) */
}

#endif
