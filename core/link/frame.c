#include "core/link/frame.h"

#include "core/link/crc16.h"

/* The type, and the CRC. */
enum { TYPE_BYTES = 1, CRC_BYTES = 2 };

static void put_byte(iso_frame_writer *const w, const uint8_t byte)
{
    w->crc = iso_crc16_byte(w->crc, byte);
    iso_cobs_put(&w->cobs, byte);
}

void iso_frame_put(iso_frame_writer *const w, uint64_t number, const size_t bytes)
{
    for (size_t i = 0; i < bytes; i++) {
        put_byte(w, (uint8_t)(number & 0xFF));
        number >>= 8;
    }
}

void iso_frame_put_reals(iso_frame_writer *const w, const real *const x, const size_t n)
{
    for (size_t i = 0; i < n; i++) {
        iso_frame_put(w, iso_bits_of(x[i]), sizeof *x);
    }
}

void iso_frame_begin(iso_frame_writer *const w, uint8_t *const buffer, const uint8_t type)
{
    buffer[0] = 0;
    *w = (iso_frame_writer){.cobs = {.to = buffer, .used = 1}, .crc = ISO_CRC16_START};
    iso_cobs_open(&w->cobs);
    put_byte(w, type);
}

size_t iso_frame_end(iso_frame_writer *const w)
{
    iso_frame_put(w, w->crc, CRC_BYTES);
    iso_cobs_close(&w->cobs);
    w->cobs.to[w->cobs.used++] = 0;
    return w->cobs.used;
}

iso_frame_state iso_frame_take(iso_frame_reader *const r, const uint8_t byte, size_t *const length)
{
    if (byte != 0) {
        if (r->used < r->room) {
            r->buffer[r->used] = byte;
        }
        r->used += r->used <= r->room;
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
