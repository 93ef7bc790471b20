/* Holds: a relative speed of joints that an effort between two limits keeps at zero, as dry friction, a brake or a
 * clutch does. The mode of a hold is a state: 0 where it is stuck, 1 and -1 where it slips forward and back.
 *
 * With the mobility A of the relative speeds and their accelerations a without any hold, the efforts are
 *
 *     of what slips: given;    of what is stuck, with the rows S of A:    A_SS effort_S = -(a_S + A_SF effort_F).
 *
 * All holds settle at one instant by a fixed number of passes over one A and a, of which only the rows change: what was
 * released at this instant, has no speed and accelerates against its own direction sticks again, the worst first; else
 * the one whose effort is farthest beyond its limit is released, against its effort. Of equal ones the first counts.
 * (All sets of modes that are consistent: Pfeiffer and Glocker 1996, Multibody Dynamics with Unilateral Contacts.)
 */
#ifndef ISO_CORE_METHODS_HOLD_H
#define ISO_CORE_METHODS_HOLD_H

#include "core/numbers/real.h"
#include "core/numbers/unroll.h"

/* numbers[ISO_HOLD_NUMBERS] at the states x, with the inputs and memories u and the tunables p. Of each hold its speed;
 * the acceleration of that without any hold; the least and the largest effort by which it sticks; the effort while it
 * slips forward, and while it slips back; then the lower triangle of the mobility, row by row. */
typedef void iso_hold_function(real *numbers, const real *x, const real *u, const real *p);

#define ISO_HOLD_NUMBERS(m) (6 * (size_t)(m) + ISO_HOLD_TRIANGLE(m))
#define ISO_HOLD_TRIANGLE(m) ((size_t)(m) * ((size_t)(m) + 1) / 2)

/* Reals of work space for the efforts, and for all that events do with holds: numbers and efforts at both ends of a
 * span and between; what was released. */
#define ISO_HOLD_WORK(m) (3 * (ISO_HOLD_NUMBERS(m) + (size_t)(m)) + 2 * (size_t)(m) + ISO_HOLD_TRIANGLE(m))

/* The holds of a plant, in the order of its text: the states that are their modes, their speeds, and the speeds that
 * these are relative to; a hold of one joint has its own speed there too. */
typedef struct iso_holds {
    size_t count;
    iso_hold_function *numbers;
    const uint16_t *modes, *speeds, *against; /* [count] */
} iso_holds;

/* The numbers of holds and their efforts at some states. */
typedef struct iso_holding {
    real *numbers; /* [ISO_HOLD_NUMBERS] */
    real *effort;  /* [count] */
} iso_holding;

/* The share of its limit, as an effort, by which a hold that was released may accelerate against its direction: below
 * it, that is rounding. */
#define ISO_HOLD_SHARE R(1e-4)

/* The share of a mobility below which what is left of it is rounding: other holds hold this one already. */
#define ISO_HOLD_ROUNDING (R(256.0) * ISO_REAL_EPSILON)

enum { ISO_HOLD_SPEED, ISO_HOLD_FREE, ISO_HOLD_LEAST, ISO_HOLD_MOST, ISO_HOLD_FORWARD, ISO_HOLD_BACK, ISO_HOLD_PARTS };

/* One of the numbers of a hold. */
ISO_INLINE real iso_hold_part(const iso_holds *const holds, const real *const numbers, const unsigned part,
                              const size_t i)
{
    return numbers[part * holds->count + i];
}

/* The acceleration of hold i by a unit effort of hold j. */
ISO_INLINE real iso_hold_mobility(const iso_holds *const holds, const real *const numbers, const size_t i,
                                  const size_t j)
{
    const size_t low = i < j ? i : j, high = i < j ? j : i;
    return numbers[ISO_HOLD_PARTS * holds->count + ISO_HOLD_TRIANGLE(high) + low];
}

/* All ones where x is other than zero. */
ISO_INLINE iso_bits iso_is_nonzero(const real x)
{
    return iso_less(R(0.0), iso_abs(x));
}

/* 1 or -1, as x is above zero or not. */
ISO_INLINE real iso_side(const real x)
{
    return iso_select(iso_less(R(0.0), x), R(1.0), R(-1.0));
}

/* The efforts of what slips, and -(a + A effort) of what is stuck: right[count], zero of the others. */
ISO_INLINE void iso_hold_slipping(const iso_holds *const holds, const real *const numbers, const real *const x,
                                  real *const effort, real *const right)
{
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        const real mode = x[holds->modes[i]];
        const real slips = iso_select(iso_less(R(0.0), mode), iso_hold_part(holds, numbers, ISO_HOLD_FORWARD, i),
                                      iso_hold_part(holds, numbers, ISO_HOLD_BACK, i));
        effort[i] = iso_select(iso_is_nonzero(mode), slips, R(0.0));
    }
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        real sum = iso_hold_part(holds, numbers, ISO_HOLD_FREE, i);
        ISO_UNROLL
        for (size_t j = 0; j < holds->count; j++) {
            sum += iso_hold_mobility(holds, numbers, i, j) * effort[j];
        }
        right[i] = iso_select(iso_is_nonzero(x[holds->modes[i]]), R(0.0), -sum);
    }
}

/* Row i of L D L' = A in the rows and columns that are stuck, and the identity in the others; 1 / D on the diagonal.
 * The rows before it are known. */
ISO_INLINE void iso_hold_factor(const iso_holds *const holds, const real *const numbers, const real *const x,
                                real *const factors, const size_t i)
{
    real *const row = factors + ISO_HOLD_TRIANGLE(i);
    const iso_bits slips = iso_is_nonzero(x[holds->modes[i]]);
    const real own = iso_hold_mobility(holds, numbers, i, i);
    real pivot = iso_select(slips, R(1.0), own);
    ISO_UNROLL
    for (size_t j = 0; j < i; j++) {
        const iso_bits apart = slips | iso_is_nonzero(x[holds->modes[j]]);
        const real *const above = factors + ISO_HOLD_TRIANGLE(j);
        row[j] = iso_select(apart, R(0.0), iso_hold_mobility(holds, numbers, i, j));
        ISO_UNROLL
        for (size_t k = 0; k < j; k++) {
            row[j] -= row[k] * above[k];
        }
    }
    ISO_UNROLL
    for (size_t k = 0; k < i; k++) {
        const real factor = row[k] * factors[ISO_HOLD_TRIANGLE(k) + k];
        pivot -= factor * row[k];
        row[k] = factor;
    }
    const iso_bits is_held = ~slips & ~iso_less(ISO_HOLD_ROUNDING * own, pivot);
    row[i] = iso_select(is_held, R(0.0), R(1.0) / iso_select(is_held, R(1.0), pivot));
}

/* effort[count] by the modes in x; work[triangle + count]. */
ISO_INLINE void iso_hold_efforts(const iso_holds *const holds, const real *const numbers, const real *const x,
                                 real *const effort, real *const work)
{
    const size_t m = holds->count;
    real *const right = work + ISO_HOLD_TRIANGLE(m);
    iso_hold_slipping(holds, numbers, x, effort, right);
    ISO_UNROLL
    for (size_t i = 0; i < m; i++) {
        iso_hold_factor(holds, numbers, x, work, i);
        ISO_UNROLL
        for (size_t k = 0; k < i; k++) {
            right[i] -= work[ISO_HOLD_TRIANGLE(i) + k] * right[k];
        }
    }
    ISO_UNROLL
    for (size_t i = m; i-- > 0;) {
        right[i] *= work[ISO_HOLD_TRIANGLE(i) + i];
        ISO_UNROLL
        for (size_t k = i + 1; k < m; k++) {
            right[i] -= work[ISO_HOLD_TRIANGLE(k) + i] * right[k];
        }
        effort[i] = iso_select(iso_is_nonzero(x[holds->modes[i]]), effort[i], right[i]);
    }
}

/* Numbers and efforts at x. */
ISO_INLINE void iso_hold_find(const iso_holds *const holds, const real *const x, const real *const u,
                              const real *const p, const iso_holding *const to, real *const work)
{
    holds->numbers(to->numbers, x, u, p);
    iso_hold_efforts(holds, to->numbers, x, to->effort, work);
}

/* What the effort of hold i leaves to its limit: the upper one where `up` is all ones. */
ISO_INLINE real iso_hold_margin(const iso_holds *const holds, const iso_holding *const at, const size_t i,
                                const iso_bits up)
{
    const real effort = at->effort[i];
    return iso_select(up, iso_hold_part(holds, at->numbers, ISO_HOLD_MOST, i) - effort,
                      effort - iso_hold_part(holds, at->numbers, ISO_HOLD_LEAST, i));
}

/* --- settling --- */

/* By how much of its limit hold i, which was released at this instant, accelerates against its direction as an effort;
 * zero of others. */
ISO_INLINE real iso_hold_wrong(const iso_holds *const holds, const iso_holding *const at, const real *const x,
                               const real fresh, const size_t i)
{
    real acceleration = iso_hold_part(holds, at->numbers, ISO_HOLD_FREE, i);
    ISO_UNROLL
    for (size_t j = 0; j < holds->count; j++) {
        acceleration += iso_hold_mobility(holds, at->numbers, i, j) * at->effort[j];
    }
    const real mode = x[holds->modes[i]];
    const real limit = iso_select(iso_less(R(0.0), mode), -iso_hold_part(holds, at->numbers, ISO_HOLD_LEAST, i),
                                  iso_hold_part(holds, at->numbers, ISO_HOLD_MOST, i));
    const real against = -mode * acceleration / iso_hold_mobility(holds, at->numbers, i, i);
    const iso_bits moves = iso_is_nonzero(iso_hold_part(holds, at->numbers, ISO_HOLD_SPEED, i));
    const iso_bits is_wrong = iso_is_nonzero(fresh) & ~moves & iso_less(ISO_HOLD_SHARE * limit, against);
    return iso_select(is_wrong, against / iso_max(limit, iso_all(ISO_REAL_LEAST / ISO_REAL_EPSILON)), R(0.0));
}

/* The effort of hold i over its limit where it is stuck and beyond it; else zero. */
ISO_INLINE real iso_hold_excess(const iso_holds *const holds, const iso_holding *const at, const real *const x,
                                const size_t i)
{
    const iso_bits up = iso_less(R(0.0), at->effort[i]);
    const real limit = iso_select(up, iso_hold_part(holds, at->numbers, ISO_HOLD_MOST, i),
                                  -iso_hold_part(holds, at->numbers, ISO_HOLD_LEAST, i));
    const real size = iso_abs(at->effort[i]);
    const iso_bits is_beyond = ~iso_is_nonzero(x[holds->modes[i]]) & iso_less(limit, size);
    return iso_select(is_beyond, size / iso_max(limit, iso_all(ISO_REAL_LEAST / ISO_REAL_EPSILON)), R(0.0));
}

/* One change of mode at most: of the hold that is farthest beyond what it may be. */
ISO_INLINE void iso_hold_pass(const iso_holds *const holds, const iso_holding *const at, real *const x,
                              real *const fresh)
{
    real worst = R(0.0), largest = R(0.0);
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        worst = iso_max(worst, iso_hold_wrong(holds, at, x, fresh[i], i));
        largest = iso_max(largest, iso_hold_excess(holds, at, x, i));
    }
    const iso_bits sticks = iso_is_nonzero(worst), breaks = ~sticks & iso_is_nonzero(largest);
    iso_bits left = iso_mask_where(true);
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        real *const mode = &x[holds->modes[i]];
        const real wrong = iso_hold_wrong(holds, at, x, fresh[i], i), excess = iso_hold_excess(holds, at, x, i);
        const iso_bits is_worst = left & sticks & ~iso_less(wrong, worst);
        const iso_bits is_largest = left & breaks & ~iso_less(excess, largest);
        *mode = iso_select(is_worst, R(0.0), iso_select(is_largest, -iso_side(at->effort[i]), *mode));
        fresh[i] = iso_select(is_worst, R(0.0), iso_select(is_largest, R(1.0), fresh[i]));
        left &= ~(is_worst | is_largest);
    }
}

/* From the efforts at x to those behind all changes of modes at this instant; fresh[count] is not zero of what has been
 * released at it. */
ISO_INLINE void iso_hold_settle(const iso_holds *const holds, const iso_holding *const at, real *const x,
                                real *const fresh, real *const work)
{
    const size_t passes = holds->count < 2 ? 3 : 2 * holds->count - 1;
    ISO_UNROLL
    for (size_t i = 0; i < passes; i++) {
        iso_hold_pass(holds, at, x, fresh);
        iso_hold_efforts(holds, at->numbers, x, at->effort, work);
    }
}

/* The parts of the work space. */
typedef struct iso_hold_room {
    iso_holding from, to, at;
    real *fresh, *work;
} iso_hold_room;

ISO_INLINE iso_hold_room iso_hold_room_of(const iso_holds *const holds, real *const room)
{
    const size_t numbers = ISO_HOLD_NUMBERS(holds->count), one = numbers + holds->count;
    return (iso_hold_room){.from = {room, room + numbers},
                           .to = {room + one, room + one + numbers},
                           .at = {room + 2 * one, room + 2 * one + numbers},
                           .fresh = room + 3 * one,
                           .work = room + 3 * one + holds->count};
}

/* At a start: what has a speed slips, the rest sticks; then they settle. room[ISO_HOLD_WORK] */
ISO_INLINE void iso_holds_begin(const iso_holds *const holds, real *const x, const real *const u, const real *const p,
                                real *const room)
{
    const iso_hold_room space = iso_hold_room_of(holds, room);
    holds->numbers(space.at.numbers, x, u, p);
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        const real speed = iso_hold_part(holds, space.at.numbers, ISO_HOLD_SPEED, i);
        x[holds->modes[i]] = iso_select(iso_is_nonzero(speed), iso_side(speed), R(0.0));
        space.fresh[i] = R(0.0);
    }
    iso_hold_efforts(holds, space.at.numbers, x, space.at.effort, space.work);
    iso_hold_settle(holds, &space.at, x, space.fresh, space.work);
}

/* --- the place in a span at which a hold that is stuck breaks, from 0 to 1; 2 where it does not --- */

/* The secant through both ends. */
ISO_INLINE real iso_hold_first_place(const iso_holds *const holds, const iso_hold_room *const space,
                                     const real *const x, const size_t i)
{
    const iso_bits up = iso_less(R(0.0), space->to.effort[i]), is_stuck = ~iso_is_nonzero(x[holds->modes[i]]);
    const real begin = iso_hold_margin(holds, &space->from, i, up), end = iso_hold_margin(holds, &space->to, i, up);
    const iso_bits is_over = iso_is_nonzero(iso_hold_excess(holds, &space->from, x, i));
    const iso_bits crosses = is_stuck & ~is_over & iso_less(end, R(0.0));
    const real secant = begin / iso_select(crosses, begin - end, R(1.0));
    return iso_select(is_over, R(0.0), iso_select(crosses, iso_clamp(secant, R(0.0), R(1.0)), R(2.0)));
}

/* The parabola through both ends and the place `near`, where `at` is known, by steps of Newton's method. */
ISO_INLINE real iso_hold_place(const iso_holds *const holds, const iso_hold_room *const space, const real *const x,
                               const real near, const size_t i)
{
    enum { STEPS = 3 };
    const iso_bits up = iso_less(R(0.0), space->to.effort[i]);
    const real begin = iso_hold_margin(holds, &space->from, i, up), end = iso_hold_margin(holds, &space->to, i, up);
    const real first = (iso_hold_margin(holds, &space->at, i, up) - begin) / near;
    const real bend = (end - begin - first) / (R(1.0) - near);
    const real secant = iso_hold_first_place(holds, space, x, i);
    const iso_bits crosses = iso_less(R(0.0), secant) & iso_less(secant, R(1.5));
    real place = iso_select(crosses, secant, R(0.5));
    ISO_UNROLL
    for (int k = 0; k < STEPS; k++) {
        const real value = begin + place * (first + bend * (place - near));
        const real slope = first + bend * (R(2.0) * place - near);
        const iso_bits falls = iso_less(slope, R(0.0));
        place = iso_clamp(place - iso_select(falls, value / iso_select(falls, slope, R(1.0)), R(0.0)), R(0.0), R(1.0));
    }
    return iso_select(crosses, place, secant);
}

/* --- at the instant of an event --- */

/* The own event of hold i, where the mask is all ones: one that slips stops, one that is stuck is released. */
ISO_INLINE void iso_hold_own(const iso_holds *const holds, const iso_hold_room *const space, const iso_bits own,
                             real *const x, const size_t i)
{
    const bool is_alone = holds->against[i] == holds->speeds[i];
    const iso_bits slips = iso_is_nonzero(x[holds->modes[i]]), stops = own & slips;
    real *const speed = &x[holds->speeds[i]];
    *speed = iso_select(stops, is_alone ? R(0.0) : x[holds->against[i]], *speed);
    x[holds->modes[i]] = iso_select(stops, R(0.0), x[holds->modes[i]]);
    space->fresh[i] = iso_select(own & ~slips, R(1.0), R(0.0));
}

/* The mode of hold i behind an event: the direction of its speed, by which an impulse, where it strikes, breaks it too;
 * what is released has no speed, and slips against its effort. */
ISO_INLINE void iso_hold_renew(const iso_holds *const holds, const iso_hold_room *const space, const iso_bits strikes,
                               real *const x, const size_t i)
{
    const bool is_alone = holds->against[i] == holds->speeds[i];
    real *const mode = &x[holds->modes[i]];
    const real speed = iso_hold_part(holds, space->at.numbers, ISO_HOLD_SPEED, i);
    const real both = iso_abs(x[holds->speeds[i]]) + (is_alone ? R(0.0) : iso_abs(x[holds->against[i]]));
    const iso_bits moves = iso_less(ISO_HOLD_ROUNDING * both, iso_abs(speed));
    const iso_bits slips = strikes | iso_is_nonzero(*mode), fresh = iso_is_nonzero(space->fresh[i]);
    const real still = iso_select(fresh, -iso_side(space->at.effort[i]), iso_select(strikes, R(0.0), *mode));
    *mode = iso_select(moves & slips, iso_side(speed), still);
}

/* All holds behind an event that has been carried out in x, with their own ones. */
ISO_INLINE void iso_hold_change(const iso_holds *const holds, const iso_hold_room *const space, const iso_bits strikes,
                                real *const x, const real *const u, const real *const p)
{
    iso_hold_find(holds, x, u, p, &space->at, space->work);
    ISO_UNROLL
    for (size_t i = 0; i < holds->count; i++) {
        iso_hold_renew(holds, space, strikes, x, i);
    }
    iso_hold_efforts(holds, space->at.numbers, x, space->at.effort, space->work);
    iso_hold_settle(holds, &space->at, x, space->fresh, space->work);
}

#endif
