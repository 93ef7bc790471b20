/* Shared by the program of `isochron conform` and its reader. */
#ifndef ISO_CORE_CONFORM_PATTERN_H
#define ISO_CORE_CONFORM_PATTERN_H

#include <stdint.h>

/* Bytes through the console, and through the channel and back. A divisor of neither is a power of two. */
enum { CONFORM_CONSOLE_BYTES = 19683, CONFORM_CHANNEL_BYTES = 6561 };

/* The first byte out of the channel. */
enum { CONFORM_OPEN = 0x7E };

/* The duration of the program's run, in nanoseconds: more than 32 bits, with all digits. */
#define CONFORM_DURATION UINT64_C(9876543210)

/* The byte of this number: all values, one after another, in an order without a short period. */
static inline uint8_t conform_byte(const uint32_t i)
{
    const uint32_t mixed = (i + 1) * UINT32_C(2654435761);
    return (uint8_t)(i < 256 ? i : mixed >> 24);
}

#endif
