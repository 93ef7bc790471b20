#include "tools/link/link.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

enum { CHUNK_BYTES = 65536 };

void direction_start(direction *const w)
{
    w->reader = (iso_frame_reader){.buffer = w->frame, .room = sizeof w->frame};
    w->piece_bytes = 0;
    w->queued = 0;
}

bool direction_has_room(const direction *const w)
{
    return w->queued + sizeof w->piece + 2 * CHUNK_BYTES <= sizeof w->queue;
}

/* Passes a piece on as it came, unless `look` has changed it. */
static void pass(direction *const w, const bool whole, const size_t length, direction_look *const look,
                 void *const context)
{
    if (whole && look(context, w->frame, length)) {
        iso_frame_writer out = iso_frame_begin(w->piece, w->frame[0]);
        for (size_t i = 0; i < length; i++) {
            iso_frame_put(&out, w->frame[1 + i], 1);
        }
        w->piece_bytes = iso_frame_end(&out);
    }
    memcpy(w->queue + w->queued, w->piece, w->piece_bytes);
    w->queued += w->piece_bytes;
    w->piece_bytes = 0;
}

bool direction_read(direction *const w, const int file, direction_look *const look, void *const context)
{
    uint8_t bytes[CHUNK_BYTES];
    const ssize_t count = read(file, bytes, sizeof bytes);
    for (ssize_t i = 0; i < count; i++) {
        size_t length = 0;
        w->piece[w->piece_bytes++] = bytes[i];
        const iso_frame_state state = iso_frame_take(&w->reader, bytes[i], &length);
        if (bytes[i] == 0 || w->piece_bytes == sizeof w->piece) {
            pass(w, state == ISO_FRAME_WHOLE, length, look, context);
        }
    }
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

bool direction_write(direction *const w, const int file)
{
    const ssize_t count = w->queued == 0 ? 0 : write(file, w->queue, w->queued);
    if (count > 0) {
        w->queued -= (size_t)count;
        memmove(w->queue, w->queue + count, w->queued);
    }
    return count >= 0 || errno == EAGAIN || errno == EINTR;
}
