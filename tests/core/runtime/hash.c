/* core/runtime/hash.h: FNV-1a in 64 bits against the vectors of its authors. */
#include "core/runtime/hash.h"
#include "tests/tap.h"

/* The hash of reals that consist of the bytes of a text, as many as they hold. */
static uint64_t hash_of_text(const char *const text)
{
    real x[2];
    iso_bits bits[2] = {0};
    const size_t length = strlen(text);
    for (size_t i = 0; i < length; i++) {
        bits[i / sizeof(real)] |= (iso_bits)(uint8_t)text[i] << (8 * (i % sizeof(real)));
    }
    memcpy(x, bits, sizeof x);
    return iso_hash_reals(ISO_HASH_START, x, length / sizeof(real));
}

int main(void)
{
    tap_bits(hash_of_text(""), UINT64_C(0xcbf29ce484222325), "no byte: the offset basis");
#ifdef ISO_REAL_DOUBLE
    tap_bits(hash_of_text("chongo w"), UINT64_C(0xd1edd10b507344d0), "eight bytes of a known text");
#else
    tap_bits(hash_of_text("foob"), UINT64_C(0xdd120e790c2512af), "four bytes of a known text");
#endif

    const real x[3] = {R(1.0), R(-0.0), R(2.5)};
    const uint64_t whole = iso_hash_reals(ISO_HASH_START, x, 3);
    const uint64_t parts = iso_hash_reals(iso_hash_reals(ISO_HASH_START, x, 1), x + 1, 2);
    tap_bits(parts, whole, "a hash can be continued");

    const real other[3] = {R(1.0), R(0.0), R(2.5)};
    tap_ok(iso_hash_reals(ISO_HASH_START, other, 3) != whole, "the sign of zero counts");
    const real swapped[3] = {R(2.5), R(-0.0), R(1.0)};
    tap_ok(iso_hash_reals(ISO_HASH_START, swapped, 3) != whole, "the order counts");
    tap_done();
}
