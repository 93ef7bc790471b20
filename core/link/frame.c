#include "core/link/frame.h"

#include "core/link/crc16.h"

/* The type, and the CRC. */
enum { TYPE_BYTES = 1, CRC_BYTES = 2 };

/* Behind a zero, and the code of the first block. */
enum { FRAME_AT = 2 };

/* Least significant byte first; a compiler makes one store of it where it may. */
static void put_word(uint8_t *const to, const uint32_t word)
{
    to[0] = (uint8_t)(word & 0xFF);
    to[1] = (uint8_t)(word >> 8 & 0xFF);
    to[2] = (uint8_t)(word >> 16 & 0xFF);
    to[3] = (uint8_t)(word >> 24);
}

void iso_frame_put(iso_frame_writer *const w, uint64_t number, const size_t bytes)
{
    uint8_t *at = w->buffer + w->used;
    const uint8_t *const end = at + bytes;
    for (; end - at >= 4; at += 4) {
        put_word(at, (uint32_t)number);
        number >>= 32;
    }
    for (uint32_t rest = (uint32_t)number; at < end; rest >>= 8) {
        *at++ = (uint8_t)(rest & 0xFF);
    }
    w->used += bytes;
}

void iso_frame_put_reals(iso_frame_writer *const w, const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        iso_frame_put(w, iso_bits_of(x[i]), sizeof *x);
    }
}

iso_frame_writer iso_frame_begin(uint8_t *const buffer, const uint8_t type)
{
    buffer[0] = 0;
    buffer[FRAME_AT] = type;
    return (iso_frame_writer){.buffer = buffer, .used = FRAME_AT + TYPE_BYTES};
}

size_t iso_frame_end(iso_frame_writer *const w)
{
    iso_frame_put(w, iso_crc16(ISO_CRC16_START, w->buffer + FRAME_AT, w->used - FRAME_AT), CRC_BYTES);
    w->used = 1 + iso_cobs_encode(w->buffer + 1, w->used - FRAME_AT);
    w->buffer[w->used++] = 0;
    return w->used;
}

size_t iso_frame_take_run(iso_frame_reader *const r, const uint8_t *const bytes, const size_t count)
{
    size_t length = 0;
    while (length < count && bytes[length] != 0) {
        length++;
    }
    if (length > 0) {
        const bool fits = r->used <= r->room && length <= r->room - r->used;
        if (fits) {
            memcpy(r->buffer + r->used, bytes, length);
        }
        r->used = fits ? r->used + length : r->room + 1;
    }
    return length;
}

iso_frame_state iso_frame_take(iso_frame_reader *const r, const uint8_t byte, size_t *const length)
{
    if (byte != 0) {
        (void)iso_frame_take_run(r, &byte, 1);
        return ISO_FRAME_OPEN;
    }
    const size_t used = r->used;
    r->used = 0;
    if (used == 0) {
        return ISO_FRAME_OPEN;
    }
    const size_t count = used > r->room ? 0 : iso_cobs_decode(r->buffer, used);
    if (count < TYPE_BYTES + CRC_BYTES) {
        return ISO_FRAME_DAMAGED;
    }
    *length = count - TYPE_BYTES - CRC_BYTES;
    const uint16_t crc = iso_crc16(ISO_CRC16_START, r->buffer, count - CRC_BYTES);
    return iso_frame_number(r->buffer + count - CRC_BYTES, CRC_BYTES) == crc ? ISO_FRAME_WHOLE : ISO_FRAME_DAMAGED;
}

uint64_t iso_frame_number(const uint8_t *const from, const size_t bytes)
{
    uint64_t number = 0;
    for (size_t i = bytes; i-- > 0;) {
        number = number << 8 | from[i];
    }
    return number;
}

real iso_frame_real(const uint8_t *const from)
{
    return iso_real_of((iso_bits)iso_frame_number(from, sizeof(real)));
}
