/* A ring of bytes between a program and an interrupt: one side moves the first place, the other the last. Places count
 * without an end; their last bits are those in the ring. */
#ifndef ISO_PORT_RING_H
#define ISO_PORT_RING_H

#include "port/channel.h"

enum { RING_BYTES = ISO_CHANNEL_BYTES };
_Static_assert((RING_BYTES & (RING_BYTES - 1)) == 0, "places go on where they wrap");

typedef struct ring {
    volatile uint32_t first, last;
    volatile uint8_t bytes[RING_BYTES]; /* so that a byte is there before its place is counted */
} ring;

/* The received bytes of each line, and the bytes to send. */
static struct {
    ring in, out;
} lines[ISO_CHANNELS];

static inline bool ring_is_full(const ring *const r)
{
    return r->last - r->first == RING_BYTES;
}

static inline bool ring_is_empty(const ring *const r)
{
    return r->last == r->first;
}

static inline void ring_put(ring *const r, const uint8_t byte)
{
    r->bytes[r->last % RING_BYTES] = byte;
    r->last++;
}

static inline uint8_t ring_take(ring *const r)
{
    const uint8_t byte = r->bytes[r->first % RING_BYTES];
    r->first++;
    return byte;
}

/* Takes up to so many bytes. Returns how many. */
static inline size_t ring_take_all(ring *const r, void *const bytes, const size_t count)
{
    uint8_t *const to = bytes;
    size_t taken = 0;
    while (taken < count && !ring_is_empty(r)) {
        to[taken++] = ring_take(r);
    }
    return taken;
}

/* Puts all bytes, or none where there is no room for them. Returns whether it did. */
static inline bool ring_put_all(ring *const r, const void *const bytes, const size_t count)
{
    const uint8_t *const from = bytes;
    if (count > RING_BYTES - (r->last - r->first)) {
        return false;
    }
    const uint32_t last = r->last;
    for (size_t i = 0; i < count; i++) {
        r->bytes[(last + i) % RING_BYTES] = from[i];
    }
    r->last = last + count;
    return true;
}

#endif
