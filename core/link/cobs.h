/* Consistent overhead byte stuffing: bytes without a zero among them, so that a zero can stand between frames.
 * Cheshire and Baker (1999), IEEE/ACM Transactions on Networking 7(2), 159-172.
 *
 * The bytes are cut at their zeros into blocks of up to 254. A code, the length of the block plus one, stands before each
 * and takes the place of the zero behind it; 255 says that there is none. */
#ifndef ISO_CORE_LINK_COBS_H
#define ISO_CORE_LINK_COBS_H

#include <stddef.h>
#include <stdint.h>

enum { ISO_COBS_FULL = 255 };

/* The most bytes that so many become. */
#define ISO_COBS_ROOM(count) ((count) + (count) / (ISO_COBS_FULL - 1) + 1)

/* Bytes on their way. */
typedef struct iso_cobs {
    uint8_t *to;
    size_t used; /* bytes of `to` */
    size_t code; /* where that of the present block stands */
} iso_cobs;

static inline void iso_cobs_open(iso_cobs *const c)
{
    c->code = c->used++;
}

static inline void iso_cobs_close(iso_cobs *const c)
{
    c->to[c->code] = (uint8_t)(c->used - c->code);
}

static inline void iso_cobs_put(iso_cobs *const c, const uint8_t byte)
{
    if (byte != 0) {
        c->to[c->used++] = byte;
    }
    if (byte == 0 || c->used - c->code == ISO_COBS_FULL) {
        iso_cobs_close(c);
        iso_cobs_open(c);
    }
}

/* Puts count bytes back to what they were, in their place. Returns how many these are; 0 if a block ends behind them. */
static inline size_t iso_cobs_decode(uint8_t *const bytes, const size_t count)
{
    size_t from = 0, to = 0;
    while (from < count) {
        const uint8_t code = bytes[from++];
        if (code == 0 || code - 1U > count - from) {
            return 0;
        }
        for (uint8_t i = 1; i < code; i++) {
            bytes[to++] = bytes[from++];
        }
        if (code < ISO_COBS_FULL && from < count) {
            bytes[to++] = 0;
        }
    }
    return to;
}

#endif
