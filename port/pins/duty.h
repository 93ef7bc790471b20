/* The part of the time that a pin is high: a counter of 16 bits counts while it is, by a divider. */
#ifndef ISO_PORT_PINS_DUTY_H
#define ISO_PORT_PINS_DUTY_H

#include <stdbool.h>
#include <stdint.h>

#include "core/numbers/real.h"

enum { DUTY_HALF = 1 << 15 };

/* The least divider with which a period, and a second one if a tick was lost, stay within the counter. */
static inline uint32_t duty_divider(const uint32_t period_cycles)
{
    return period_cycles / DUTY_HALF + 1;
}

/* v from the counts of a time of so many cycles: exact but for one count. Whether there is one: not before time has
 * passed, and not where the counter may have been through all its numbers. */
static inline bool duty_part(const uint16_t counts, const uint32_t divider, const uint32_t cycles, real *const v)
{
    if (cycles == 0 || cycles / divider >= 2 * DUTY_HALF) {
        return false;
    }
    *v = iso_clamp((real)(counts * divider) / (real)cycles, R(0.0), R(1.0));
    return true;
}

#endif
