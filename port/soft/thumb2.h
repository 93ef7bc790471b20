/* The parts of port/soft/shifts.h on an Arm core with Thumb-2. A condition there suppresses the result of an
 * instruction, not its time. */
#ifndef ISO_PORT_SOFT_THUMB2_H
#define ISO_PORT_SOFT_THUMB2_H

#include <stdint.h>

static inline uint32_t soft_left(const uint32_t x, const uint32_t count)
{
    uint32_t y;
    __asm__("lsl %0, %1, %2" : "=r"(y) : "r"(x), "r"(count));
    return y;
}

static inline uint32_t soft_right(const uint32_t x, const uint32_t count)
{
    uint32_t y;
    __asm__("lsr %0, %1, %2" : "=r"(y) : "r"(x), "r"(count));
    return y;
}

static inline uint32_t soft_zeros(const uint32_t x)
{
    uint32_t zeros;
    __asm__("clz %0, %1" : "=r"(zeros) : "r"(x));
    return zeros;
}

static inline uint32_t soft_positive(const uint32_t x)
{
    uint32_t y;
    __asm__("usat %0, #31, %1" : "=r"(y) : "r"(x));
    return y;
}

static inline uint32_t soft_upper(const uint32_t x)
{
    uint32_t y;
    __asm__("usat %0, #8, %1, asr #23" : "=r"(y) : "r"(x - (UINT32_C(1) << 23)));
    return y;
}

/* A half is rounded up and then made even. */
static inline uint32_t soft_rounded(uint32_t x, const uint32_t behind, const uint32_t upper)
{
    __asm__("cmp %1, #0x80000000\n"
            "adc %0, %0, %2, lsl #23\n"
            "it eq\n"
            "biceq %0, %0, #1"
            : "+r"(x)
            : "r"(behind), "r"(upper)
            : "cc");
    return x;
}

#endif
