/* One direction of a wire: what comes in at one end goes out at the other, frame by frame; damaged ones as they are. */
#ifndef ISO_TOOLS_LINK_WAY_H
#define ISO_TOOLS_LINK_WAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/link/frame.h"

/* More than the largest frame, of 65535 outputs in double. */
enum { WAY_FRAME_BYTES = 1 << 20, WAY_QUEUE_BYTES = 3 << 20 };

typedef struct way {
    iso_frame_reader reader;
    uint8_t frame[WAY_FRAME_BYTES]; /* what the reader has */
    uint8_t piece[WAY_FRAME_BYTES]; /* the same as it came */
    size_t piece_bytes;
    uint8_t queue[WAY_QUEUE_BYTES]; /* on its way out */
    size_t queued;
} way;

/* Looks at a frame that is whole: its type, and its payload, which it may change. Returns whether it has. */
typedef bool way_look(void *context, uint8_t *frame, size_t length);

void way_start(way *w);

/* Whether it takes any more. */
bool way_has_room(const way *w);

/* Reads what has come. False at the end of the stream. */
bool way_read(way *w, int file, way_look *look, void *context);

/* Writes what goes. False if nobody is there. */
bool way_write(way *w, int file);

#endif
