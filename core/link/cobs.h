/* Consistent overhead byte stuffing: bytes without a zero among them, so that a zero can stand between frames.
 * Cheshire and Baker (1999), IEEE/ACM Transactions on Networking 7(2), 159-172.
 *
 * The bytes are cut at their zeros into blocks of up to 254. A code, the length of the block plus one, stands before
 * each and takes the place of the zero behind it; 255 means that there is none. */
#ifndef ISO_CORE_LINK_COBS_H
#define ISO_CORE_LINK_COBS_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { ISO_COBS_FULL = 255 };

/* The most bytes that so many become. */
#define ISO_COBS_ROOM(count) ((count) + (count) / (ISO_COBS_FULL - 1) + 1)

/* Encodes the count bytes from bytes[1] on in their place, with ISO_COBS_ROOM(count) bytes from bytes[0] on. Returns
 * how many these are. Every zero becomes the code of a block, so that all else stays where it is, but behind a block
 * that is full. */
static inline size_t iso_cobs_encode(uint8_t *const bytes, const size_t count)
{
    size_t end = 1 + count, block = 0;
    for (size_t i = 1; i < end; i++) {
        if (bytes[i] == 0) {
            bytes[block] = (uint8_t)(i - block);
            block = i;
        } else if (i - block == ISO_COBS_FULL - 1) {
            bytes[block] = ISO_COBS_FULL;
            block = ++i;
            memmove(bytes + i + 1, bytes + i, end - i);
            end++;
        }
    }
    bytes[block] = (uint8_t)(end - block);
    return end;
}

/* Decodes count bytes in their place. Returns the number of decoded bytes; 0 if a block would end behind the bytes. */
static inline size_t iso_cobs_decode(uint8_t *const bytes, const size_t count)
{
    size_t from = 0, to = 0;
    while (from < count) {
        const uint8_t block_code = bytes[from++];
        if (block_code == 0 || block_code - 1U > count - from) {
            return 0;
        }
        for (uint8_t i = 1; i < block_code; i++) {
            bytes[to++] = bytes[from++];
        }
        if (block_code < ISO_COBS_FULL && from < count) {
            bytes[to++] = 0;
        }
    }
    return to;
}

#endif
