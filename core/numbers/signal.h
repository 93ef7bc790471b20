/* Functions of time. They use the integer tick, so they are as exact after a day as after a second. */
#ifndef ISO_CORE_NUMBERS_SIGNAL_H
#define ISO_CORE_NUMBERS_SIGNAL_H

#include "core/numbers/real.h"

/* The angle in [-pi, pi) that starts at `start` and grows by `increment` in a tick; 2^64 is one turn. */
static inline real iso_phase(const uint32_t tick, const uint64_t increment, const uint64_t start)
{
    const uint64_t turns = start + tick * increment;
#ifdef ISO_REAL_DOUBLE
    return (real)(int64_t)turns * R(3.40612158008655459e-19); /* pi / 2^63 */
#else
    return (real)(int32_t)(uint32_t)(turns >> 32) * R(1.46291807926715968e-9); /* pi / 2^31 */
#endif
}

/* The ticks since first + fraction; before the last tick that is not after it, less than -1, so that it stays below
 * zero throughout the tick that follows. */
static inline real iso_since(const uint32_t tick, const uint32_t first, const real fraction)
{
    return (tick < first ? R(-1.0) : (real)(tick - first)) - fraction;
}

/* The ticks since first + fraction, limited to [0, length]: one stretch of a table of straight lines. */
static inline real iso_ramp(const uint32_t tick, const uint32_t first, const real fraction, const real length)
{
    const uint32_t since = tick > first ? tick - first : 0;
    return iso_clamp((real)since - fraction, R(0.0), length);
}

#endif
