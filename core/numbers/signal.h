/* Functions of time. They use the integer tick, of 64 bits: they are as exact after a century as after a second. */
#ifndef ISO_CORE_NUMBERS_SIGNAL_H
#define ISO_CORE_NUMBERS_SIGNAL_H

#include "core/numbers/real.h"

/* A count of ticks as a real. The halves are whole numbers of 32 bits, which every processor converts without a branch;
 * below 2^32 it is one rounding. */
static inline real iso_real_of_ticks(const uint64_t ticks)
{
    return (iso_scalar)(uint32_t)(ticks >> 32) * R(4294967296.0) + (iso_scalar)(uint32_t)ticks;
}

/* The angle in [-pi, pi) of a phase; 2^64 is one turn. */
static inline real iso_angle_of_turns(const uint64_t turns)
{
#ifdef ISO_REAL_DOUBLE
    return (iso_scalar)(int64_t)turns * R(3.40612158008655459e-19); /* pi / 2^63 */
#else
    return (iso_scalar)(int32_t)(uint32_t)(turns >> 32) * R(1.46291807926715968e-9); /* pi / 2^31 */
#endif
}

/* The angle that starts at `start` and grows by `increment` in a tick. */
static inline real iso_phase(const uint64_t tick, const uint64_t increment, const uint64_t start)
{
    return iso_angle_of_turns(start + tick * increment);
}

/* The ticks since first + fraction; before the last tick that is not after it, less than -1, so that it stays below
 * zero throughout the tick that follows. */
static inline real iso_since(const uint64_t tick, const uint32_t first, const real fraction)
{
    return (tick < first ? R(-1.0) : iso_real_of_ticks(tick - first)) - fraction;
}

/* The ticks since first + fraction, limited to [0, length]: one stretch of a table of straight lines. */
static inline real iso_ramp(const uint64_t tick, const uint32_t first, const real fraction, const real length)
{
    const uint64_t since = tick > first ? tick - first : 0;
    return iso_clamp(iso_real_of_ticks(since) - fraction, R(0.0), length);
}

#endif
