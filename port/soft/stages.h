/* The parts of port/soft/shifts.h on a core of 8 bits that shifts by one place at a time: shifts of whole bytes are
 * moves, and those of few bits are of few bytes. Where a bit of a count is set, a mask selects the result of the stage.
 */
#ifndef ISO_PORT_SOFT_STAGES_H
#define ISO_PORT_SOFT_STAGES_H

#include <stdint.h>

/* The shifted x where that bit of the count is set, else x. */
#define SOFT_STAGE(x, became, count, bit) ((x) ^ (((x) ^ (became)) & (0 - (uint32_t)((uint8_t)(count) >> (bit)&1))))

static inline uint32_t soft_left(const uint32_t x, const uint32_t count)
{
    const uint32_t x16 = SOFT_STAGE(x, x << 16, count, 4);
    const uint32_t x8 = SOFT_STAGE(x16, x16 << 8, count, 3);
    const uint32_t x4 = SOFT_STAGE(x8, x8 << 4, count, 2);
    const uint32_t x2 = SOFT_STAGE(x4, x4 << 2, count, 1);
    const uint32_t x1 = SOFT_STAGE(x2, x2 << 1, count, 0);
    return x1 & soft_mask((count & 0xFF) - 32);
}

static inline uint32_t soft_right(const uint32_t x, const uint32_t count)
{
    const uint32_t x16 = SOFT_STAGE(x, x >> 16, count, 4);
    const uint32_t x8 = SOFT_STAGE(x16, x16 >> 8, count, 3);
    const uint32_t x4 = SOFT_STAGE(x8, x8 >> 4, count, 2);
    const uint32_t x2 = SOFT_STAGE(x4, x4 >> 2, count, 1);
    const uint32_t x1 = SOFT_STAGE(x2, x2 >> 1, count, 0);
    return x1 & soft_mask((count & 0xFF) - 32);
}

/* 1 where no bit of x is set, for x below 2^7. */
static inline uint8_t soft_is_empty(const uint8_t x)
{
    return (uint8_t)((uint8_t)(x - 1) >> 7);
}

/* By halves; the last three are of the upper byte alone. */
static inline uint32_t soft_zeros(const uint32_t x)
{
    const uint8_t empty16 = (uint8_t)(((x >> 16) - 1) >> 31);
    const uint32_t x16 = SOFT_STAGE(x, x << 16, empty16, 0);
    const uint8_t empty8 = (uint8_t)(((x16 >> 24) - 1) >> 31);
    const uint32_t x8 = SOFT_STAGE(x16, x16 << 8, empty8, 0);
    const uint8_t top = (uint8_t)(x8 >> 24);
    const uint8_t empty4 = soft_is_empty(top >> 4);
    const uint8_t top4 = (uint8_t)(top ^ ((top ^ (uint8_t)(top << 4)) & (uint8_t)(0 - empty4)));
    const uint8_t empty2 = soft_is_empty(top4 >> 6);
    const uint8_t top2 = (uint8_t)(top4 ^ ((top4 ^ (uint8_t)(top4 << 2)) & (uint8_t)(0 - empty2)));
    const uint8_t empty1 = (uint8_t)((top2 >> 7) ^ 1);
    return (uint8_t)((uint8_t)(empty16 << 4) + (uint8_t)(empty8 << 3) + (uint8_t)(empty4 << 2) +
                     (uint8_t)(empty2 << 1) + empty1);
}

static inline uint32_t soft_up(const uint32_t x)
{
    return (uint32_t)(uint16_t)((uint16_t)x << 7) << 16;
}

static inline uint32_t soft_down(const uint32_t x)
{
    return (uint16_t)((uint16_t)(x >> 16) >> 7);
}

#endif
