/* Fowler, Noll and Vo's hash FNV-1a in 64 bits: the fingerprint of a trajectory. */
#ifndef ISO_CORE_RUNTIME_HASH_H
#define ISO_CORE_RUNTIME_HASH_H

#include <stddef.h>
#include <stdint.h>

#include "core/numbers/real.h"

#define ISO_HASH_START UINT64_C(0xCBF29CE484222325)
#define ISO_HASH_PRIME UINT64_C(0x00000100000001B3)

/* The hash continued over the bytes of a number, the least significant first. */
static inline uint64_t iso_hash_word(uint64_t hash, iso_word bits)
{
    for (size_t byte = 0; byte < sizeof bits; byte++) {
        hash = (hash ^ (bits & 0xFF)) * ISO_HASH_PRIME;
        bits >>= 8;
    }
    return hash;
}

#ifdef ISO_LANES

/* Over x[n] of a lane. */
static inline uint64_t iso_hash_lane(uint64_t hash, const real *const x, const size_t n, const unsigned lane)
{
    for (size_t i = 0; i < n; i++) {
        hash = iso_hash_word(hash, iso_bits_of(x[i])[lane]);
    }
    return hash;
}

/* The hashes of all lanes, each over its x[n]. */
typedef uint64_t iso_hashes __attribute__((vector_size(ISO_LANES * sizeof(uint64_t))));

static inline iso_hashes iso_hash_lanes(iso_hashes hashes, const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        iso_hashes bits = __builtin_convertvector(iso_bits_of(x[i]), iso_hashes);
        for (size_t byte = 0; byte < sizeof(iso_word); byte++) {
            hashes = (hashes ^ (bits & 0xFF)) * ISO_HASH_PRIME;
            bits >>= 8;
        }
    }
    return hashes;
}

#else

/* Over x[n]. */
static inline uint64_t iso_hash_reals(uint64_t hash, const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        hash = iso_hash_word(hash, iso_bits_of(x[i]));
    }
    return hash;
}

#endif

#endif
