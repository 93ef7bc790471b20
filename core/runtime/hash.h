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

/* Over x[n]. */
static inline uint64_t iso_hash_reals(uint64_t hash, const iso_scalar *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        iso_word bits;
        memcpy(&bits, &x[i], sizeof bits);
        hash = iso_hash_word(hash, bits);
    }
    return hash;
}

#endif
