/* The angle of a free-spinning joint: kept in [-pi, pi), to rounding, with the whole turns counted beside it. */
#ifndef ISO_CORE_TURNS_H
#define ISO_CORE_TURNS_H

#include "core/sincos.h"

/* Takes the nearest whole number of turns off *angle (|*angle| <= 1e4) and returns it. The first two parts of pi are
 * short, so that only the last product rounds (Cody and Waite 1980). */
static inline int32_t iso_take_turns(real *const angle)
{
    const real rounded = *angle * R(0.159154943091895336) + ISO_ROUNDER;
    const real turns = rounded - ISO_ROUNDER;
    const real quarters = R(4.0) * turns;
    *angle = ((*angle - quarters * ISO_HALF_PI_1) - quarters * ISO_HALF_PI_2) - quarters * ISO_HALF_PI_3;
    return (int32_t)(uint32_t)(iso_bits_of(rounded) - iso_bits_of(ISO_ROUNDER));
}

#endif
