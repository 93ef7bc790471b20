/* Frames on a channel of bytes: a zero, then in COBS, without a zero, the type, the payload and their CRC-16, least
 * significant byte first; then a zero. Damage to the bytes of a frame, or to a zero beside it, costs that frame and no
 * other. Numbers are little-endian.
 *
 * The buffers are the caller's, as large as the largest frame: nothing here is of unknown size. */
#ifndef ISO_CORE_LINK_FRAME_H
#define ISO_CORE_LINK_FRAME_H

#include "core/link/cobs.h"
#include "core/numbers/real.h"

#define iso_frame_put_reals ISO_REAL_NAME(iso_frame_put_reals)
#define iso_frame_real ISO_REAL_NAME(iso_frame_real)

/* Bytes of a buffer for frames of up to so many bytes of payload. */
#define ISO_FRAME_BYTES(payload) (ISO_COBS_ROOM(1 + (payload) + 2) + 2)

/* A frame that is being written: its bytes, as they are until it ends. */
typedef struct iso_frame_writer {
    uint8_t *buffer;
    size_t used;
} iso_frame_writer;

iso_frame_writer iso_frame_begin(uint8_t *buffer, uint8_t type);
void iso_frame_put(iso_frame_writer *w, uint64_t number, size_t bytes);
void iso_frame_put_reals(iso_frame_writer *w, const real *x, size_t n);

/* Returns how many bytes of the buffer are the frame. */
size_t iso_frame_end(iso_frame_writer *w);

/* Frames that come in, one after another. All zeros but for the buffer at the start. */
typedef struct iso_frame_reader {
    uint8_t *buffer;
    size_t room;
    size_t used; /* room + 1: more than there is room for */
} iso_frame_reader;

typedef enum iso_frame_state { ISO_FRAME_OPEN, ISO_FRAME_WHOLE, ISO_FRAME_DAMAGED } iso_frame_state;

/* Takes a byte. Where it ends a frame that is whole, buffer[0] is the type, and behind it are *length bytes of payload,
 * until the next byte is taken. */
iso_frame_state iso_frame_take(iso_frame_reader *r, uint8_t byte, size_t *length);

/* Takes the bytes before the first zero, which do not end the frame. Returns their number. Equal to iso_frame_take byte
 * by byte. */
size_t iso_frame_take_run(iso_frame_reader *r, const uint8_t *bytes, size_t count);

/* Numbers of a payload. */
uint64_t iso_frame_number(const uint8_t *from, size_t bytes);
real iso_frame_real(const uint8_t *from);

#endif
