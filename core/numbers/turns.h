/* The angle of a joint that turns without limit: in [-pi, pi), to rounding, and the number of whole turns. */
#ifndef ISO_CORE_NUMBERS_TURNS_H
#define ISO_CORE_NUMBERS_TURNS_H

#include "core/numbers/sincos.h"

/* Subtracts the nearest whole number of turns from *angle (|*angle| <= 1e4), and returns it: quarter turns, rounded to
 * multiples of four. */
static inline int32_t iso_take_turns(real *const angle)
{
    const real rounded = *angle * R(0.636619772367581343) + R(4.0) * ISO_ROUNDER;
    *angle = iso_less_quarters(*angle, rounded - R(4.0) * ISO_ROUNDER);
    return (int32_t)(uint32_t)(iso_bits_of(rounded) - iso_bits_of(R(4.0) * ISO_ROUNDER));
}

/* The angle without its whole turns: within half a turn of zero. */
static inline real iso_within_turn(real angle)
{
    (void)iso_take_turns(&angle);
    return angle;
}

#endif
