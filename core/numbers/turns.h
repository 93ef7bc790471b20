/* The angle of a joint that turns without limit: in [-pi, pi), to rounding, the number of whole turns, and the rest:
 * the part of the angle that rounding has removed. So the angle is as exact after a day as after a second. */
#ifndef ISO_CORE_NUMBERS_TURNS_H
#define ISO_CORE_NUMBERS_TURNS_H

#include "core/numbers/exact.h"
#include "core/numbers/sincos.h"

/* Half turns, rounded to multiples of two, above ISO_TURN_ROUNDER. */
#define ISO_TURN_ROUNDER (R(2.0) * ISO_ROUNDER)

static inline real iso_round_turns(const real angle)
{
    return angle * R(0.318309886183790672) + ISO_TURN_ROUNDER;
}

/* The angle (within 1e4) without its whole turns: within half a turn of zero. */
static inline real iso_within_turn(const real angle)
{
    return iso_less_half_turns(angle, iso_round_turns(angle) - ISO_TURN_ROUNDER);
}

/* *sum += part, with the rest. */
static inline void iso_add_exactly(real *const sum, real *const rest, const real part)
{
    const real result = *sum + part;
    *rest += iso_rest_of_sum(*sum, part, result);
    *sum = result;
}

/* pi less ISO_PI_1 in two parts, the first short enough for a whole number of them to be exact. */
#ifdef ISO_REAL_DOUBLE
#define ISO_PI_MIDDLE R(1.2154201013010273e-10)
#define ISO_PI_LAST R(2.1125998133974855e-23)
#else
#define ISO_PI_MIDDLE R(-8.9071691036224365e-6)
#define ISO_PI_LAST R(-1.7411031391e-9)
#endif

/* Subtracts the nearest whole number of turns from *angle (|*angle| <= 1e4), and returns it. Without loss: the rest is
 * in the angle, as far as that can hold it. */
static inline iso_turns iso_take_turns(real *const angle, real *const rest)
{
    const real rounded = iso_round_turns(*angle), halves = rounded - ISO_TURN_ROUNDER;
    *angle -= halves * ISO_PI_1; /* exact: the two are near each other, or there is no turn */
    iso_add_exactly(angle, rest, -halves * ISO_PI_MIDDLE);
    *rest -= halves * ISO_PI_LAST;
    const real left = *rest;
    *rest = R(0.0);
    iso_add_exactly(angle, rest, left);
    return (iso_turns)(iso_count)(iso_bits_of(rounded) - iso_bits_of(ISO_TURN_ROUNDER));
}

/* The same without a rest, for an angle that something sets anew in every step. */
static inline iso_turns iso_take_whole_turns(real *const angle)
{
    const real rounded = iso_round_turns(*angle);
    *angle = iso_less_half_turns(*angle, rounded - ISO_TURN_ROUNDER);
    return (iso_turns)(iso_count)(iso_bits_of(rounded) - iso_bits_of(ISO_TURN_ROUNDER));
}

/* The count of turns with those that were taken. It wraps: behind 2147483647 comes -2147483648, so that the difference
 * of two counts is right, modulo 2^32, however long the joint has turned. */
static inline iso_turns iso_counted_turns(const iso_turns count, const iso_turns taken)
{
    return (iso_turns)((iso_count)count + (iso_count)taken);
}

/* The angle and the speed of a joint at the begin of a tick. */
typedef struct iso_turning {
    real angle;
    real speed;
} iso_turning;

/* Bound of the relative change of a way by the rounding of a method's sums and products, and of a speed by that of the
 * other forces of a steady motion. */
#define ISO_TURN_ROUNDING (R(8.0) * ISO_REAL_EPSILON)

/* Corrects the angle at the end of a tick of h + h_rest seconds, which a method has computed from the state `before`.
 * Where speed and way are steady, up to their rounding, the way is the product of speed and tick, without loss. Else it
 * is that of the method, whose h lacks h_rest. Without this, a rounding error that is the same in every tick adds up.
 * The part that the angle cannot hold is added to the rest. */
static inline void iso_turn(real *const angle, real *const rest, const iso_turning before, const real speed,
                            const real h, const real h_rest)
{
    const real way = before.speed * h, change = speed - before.speed;
    const real off = (*angle - before.angle) - way;
    const iso_bits varies = iso_less(ISO_TURN_ROUNDING * iso_abs(before.speed), iso_abs(change)) |
                            iso_less(ISO_TURN_ROUNDING * (iso_abs(before.angle) + iso_abs(way)), iso_abs(off)) |
                            iso_not_finite(*angle);
    const real lost = iso_rest_of_product(before.speed, h, way) + R(0.5) * h * change;
    *angle = iso_select(varies, *angle, before.angle);
    iso_add_exactly(angle, rest, iso_select(varies, R(0.0), way));
    *rest += iso_select(varies, R(0.0), lost) + before.speed * h_rest;
}

#endif
