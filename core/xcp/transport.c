#include "core/xcp/transport.h"

static uint16_t sum_of(const uint8_t *const words, const uint16_t bytes)
{
    uint16_t sum = 0;
    for (uint16_t i = 0; i < bytes; i += 2) {
        sum = (uint16_t)(sum + iso_xcp_word(words + i));
    }
    return sum;
}

static bool has_length(const iso_xcp_reader *const r)
{
    const uint16_t length = iso_xcp_word(r->bytes);
    return length > 0 && length <= ISO_XCP_MAX_CTO;
}

static bool is_whole(const iso_xcp_reader *const r)
{
    const uint16_t summed = iso_xcp_summed_bytes(iso_xcp_word(r->bytes));
    return !r->is_serial || sum_of(r->bytes, summed) == iso_xcp_word(r->bytes + summed);
}

static void drop(iso_xcp_reader *const r, const uint8_t count)
{
    r->used = (uint8_t)(r->used - count);
    for (uint8_t i = 0; i < r->used; i++) {
        r->bytes[i] = r->bytes[i + count];
    }
}

uint16_t iso_xcp_missing(const iso_xcp_reader *const r)
{
    const uint16_t whole = r->used < ISO_XCP_HEADER_BYTES ? ISO_XCP_HEADER_BYTES
                                                          : iso_xcp_frame_bytes(iso_xcp_word(r->bytes), r->is_serial);
    return (uint16_t)(whole - r->used);
}

uint16_t iso_xcp_read(iso_xcp_reader *const r)
{
    if (r->taken > 0) {
        drop(r, r->taken);
        r->taken = 0;
    }
    while (r->used >= ISO_XCP_HEADER_BYTES) {
        const uint16_t length = iso_xcp_word(r->bytes);
        const bool is_possible = has_length(r);
        if (is_possible && r->used < iso_xcp_frame_bytes(length, r->is_serial)) {
            return 0;
        }
        if (is_possible && is_whole(r)) {
            r->taken = (uint8_t)iso_xcp_frame_bytes(length, r->is_serial);
            return length;
        }
        drop(r, 1);
        r->skipped++;
    }
    return 0;
}

uint16_t iso_xcp_frame(uint8_t *const frame, const uint16_t length, const uint16_t counter, const bool is_serial)
{
    iso_xcp_put_word(frame, length);
    iso_xcp_put_word(frame + 2, counter);
    if (is_serial) {
        const uint16_t summed = iso_xcp_summed_bytes(length);
        frame[summed - 1] = length & 1 ? 0 : frame[summed - 1];
        iso_xcp_put_word(frame + summed, sum_of(frame, summed));
    }
    return iso_xcp_frame_bytes(length, is_serial);
}
