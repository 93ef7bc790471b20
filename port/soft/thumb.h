/* The parts of port/soft/shifts.h on an Arm core that has 16-bit Thumb instructions alone. */
#ifndef ISO_PORT_SOFT_THUMB_H
#define ISO_PORT_SOFT_THUMB_H

#include <stdint.h>

static inline uint32_t soft_left(uint32_t x, const uint32_t count)
{
    __asm__("lsls %0, %1" : "+l"(x) : "l"(count) : "cc");
    return x;
}

static inline uint32_t soft_right(uint32_t x, const uint32_t count)
{
    __asm__("lsrs %0, %1" : "+l"(x) : "l"(count) : "cc");
    return x;
}

/* Where the upper `bits` of x are zero, x goes up by 2^log = bits, and that is added to zeros. */
#define SOFT_HALF(bits, log)                                                                                           \
    "lsrs %2, %1, #32 - " bits "\n"                                                                                    \
    "subs %2, #1\n"                                                                                                    \
    "lsrs %2, #31\n"                                                                                                   \
    "lsls %2, #" log "\n"                                                                                              \
    "lsls %1, %2\n"                                                                                                    \
    "adds %0, %0, %2\n"

static inline uint32_t soft_zeros(uint32_t x)
{
    uint32_t zeros, half;
    __asm__("movs %0, #1\n" SOFT_HALF("16", "4") SOFT_HALF("8", "3") SOFT_HALF("4", "2")
                SOFT_HALF("2", "1") "lsrs %1, #31\n"
                                    "subs %0, %0, %1"
            : "=&l"(zeros), "+&l"(x), "=&l"(half)
            :
            : "cc");
    return zeros;
}

/* The carry of a sum is the amount to add. */
static inline uint32_t soft_rounded(const uint32_t x, const uint32_t behind, const uint32_t upper)
{
    uint32_t sum = behind + (x & 1), y = x;
    __asm__("adds %1, %1, %2\n"
            "adcs %0, %3"
            : "+l"(y), "+l"(sum)
            : "l"(UINT32_MAX >> 1), "l"(upper << 23)
            : "cc");
    return y;
}

#endif
