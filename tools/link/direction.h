/* One direction of a wire: bytes from one end go out at the other, frame by frame; damaged frames as they are. */
#ifndef ISO_TOOLS_LINK_DIRECTION_H
#define ISO_TOOLS_LINK_DIRECTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/link/frame.h"

/* More than the largest frame, of 65535 outputs in double. */
enum { DIRECTION_FRAME_BYTES = 1 << 20, DIRECTION_QUEUE_BYTES = 3 << 20 };

typedef struct direction {
    iso_frame_reader reader;
    uint8_t frame[DIRECTION_FRAME_BYTES]; /* the buffer of the reader */
    uint8_t piece[DIRECTION_FRAME_BYTES]; /* the same as it came */
    size_t piece_bytes;
    uint8_t queue[DIRECTION_QUEUE_BYTES]; /* on its way out */
    size_t queued;
} direction;

/* Looks at a frame that is whole: its type, and its payload, which it may change. Returns whether it has. */
typedef bool direction_look(void *context, uint8_t *frame, size_t length);

void direction_start(direction *w);

/* Whether it takes any more. */
bool direction_has_room(const direction *w);

/* Reads the received bytes. False at the end of the stream. */
bool direction_read(direction *w, int file, direction_look *look, void *context);

/* Writes the waiting bytes. False if nobody is there. */
bool direction_write(direction *w, int file);

#endif
