#include "core/xcp/service.h"

enum { MASK = 0x5A, SEED_BYTES = 4 };

/* Seeds that look different for different numbers: the finalizer of MurmurHash3. */
static uint8_t seed(const uint8_t resource, const uint64_t different, uint8_t to[ISO_XCP_SEED_BYTES])
{
    uint32_t x = (uint32_t)different + ((uint32_t)resource << 24);
    x = (x ^ x >> 16) * UINT32_C(0x85EBCA6B);
    x = (x ^ x >> 13) * UINT32_C(0xC2B2AE35);
    iso_xcp_put_long(to, x ^ x >> 16);
    return SEED_BYTES;
}

static bool fits(const uint8_t resource, const uint8_t *const bytes, const uint8_t of_length, const uint8_t *const key,
                 const uint8_t key_length)
{
    (void)resource;
    bool good = key_length == of_length;
    for (uint8_t i = 0; i < of_length && good; i++) {
        good = key[i] == (bytes[i] ^ MASK);
    }
    return good;
}

const iso_xcp_lock iso_xcp_example_lock = {ISO_XCP_CAL_PAG | ISO_XCP_DAQ | ISO_XCP_STIMULATE, seed, fits};
