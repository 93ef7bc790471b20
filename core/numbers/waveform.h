/* Test signals and tables of measured ones, as functions of the tick: their indices depend on the tick, never on data,
 * and each takes the same instructions in every tick. */
#ifndef ISO_CORE_NUMBERS_WAVEFORM_H
#define ISO_CORE_NUMBERS_WAVEFORM_H

#include "core/numbers/signal.h"

/* 0 before a tick, 1 from it on. The difference of 64 bits is negative before. */
static inline real iso_from(const uint64_t tick, const uint32_t first)
{
    return iso_whole(1 - (int32_t)((tick - first) >> 63));
}

/* tick modulo a constant below 2^24, by divisions of 32 bits, which a compiler makes multiplications: a division of 64
 * bits would be a function whose time varies. */
static inline uint32_t iso_tick_modulo(const uint64_t tick, const uint32_t period)
{
    const uint32_t high = (uint32_t)(tick >> 32), low = (uint32_t)tick;
    if (period <= UINT32_C(0x10000)) {
        const uint32_t wrap = (UINT32_MAX % period + 1) % period; /* 2^32 */
        return (high % period * wrap + low % period) % period;
    }
    const uint32_t a = (high % period << 8 | low >> 24) % period, b = (a << 8 | (low >> 16 & 255)) % period;
    const uint32_t c = (b << 8 | (low >> 8 & 255)) % period;
    return (c << 8 | (low & 255)) % period;
}

/* 1 in the first `high` ticks of a period, -1 in the others; at tick 0 it is `offset` ticks old, which is less than the
 * period of less than 2^24 ticks. */
static inline real iso_square(const uint64_t tick, const uint32_t period, const uint32_t offset, const uint32_t high)
{
    const uint32_t at = (iso_tick_modulo(tick, period) + offset) % period;
    return iso_whole(1 - 2 * (int32_t)((high - 1 - at) >> 31));
}

/* The same of a period that is no whole number of ticks: 1 in the first half turn of a phase (core/numbers/signal.h).
 */
static inline real iso_square_of_phase(const uint64_t tick, const uint64_t increment, const uint64_t start)
{
    return iso_whole(1 - 2 * (int32_t)((start + tick * increment) >> 63));
}

/* The part of a period that is over, from 0 to 1, of a phase. */
static inline real iso_cycle(const uint64_t tick, const uint64_t increment, const uint64_t start)
{
    return iso_real_of_ticks(start + tick * increment) * R(5.42101086242752217e-20); /* 1 / 2^64 */
}

/* 1 or -1: bit number tick / hold, of `length` bits that repeat after less than 2^24 ticks. */
static inline real iso_prbs(const uint64_t tick, const uint32_t *const bits, const uint32_t hold, const uint32_t length)
{
    const uint32_t at = iso_tick_modulo(tick, hold * length) / hold;
    return iso_whole(2 * (int32_t)((bits[at >> 5] >> (at & 31)) & 1) - 1);
}

/* A sweep of frequency. Phases are fractions of a turn over 2^64. */
typedef struct iso_chirp_table {
    uint64_t first, last; /* growth of the phase in a tick: at tick 0, and from the end of the sweep on */
    uint64_t curve, sign; /* half of the increase of the growth in a tick, over 2^shift; all ones: it falls */
    uint32_t shift;       /* 1 to 63 */
    uint32_t ticks;       /* of the sweep */
} iso_chirp_table;

/* a b / 2^shift modulo 2^64, from products of 32 bits (Knuth 1997, The Art of Computer Programming 2, 4.3.1). */
static inline uint64_t iso_scaled_product(const uint64_t a, const uint64_t b, const uint32_t shift)
{
    const uint64_t a_low = (uint32_t)a, a_high = a >> 32, b_low = (uint32_t)b, b_high = b >> 32;
    const uint64_t low = a_low * b_low, cross = a_high * b_low + (low >> 32);
    const uint64_t middle = a_low * b_high + (uint32_t)cross;
    const uint64_t high = a_high * b_high + (cross >> 32) + (middle >> 32);
    return (high << (64 - shift)) | (((middle << 32) | (uint32_t)low) >> shift);
}

/* The angle of the sweep in [-pi, pi): exact modulo 2^-64 turns, for the increments that the table has. */
static inline real iso_chirp(const uint64_t tick, const iso_chirp_table *const t)
{
    const uint64_t beyond = tick - t->ticks, is_within = (uint64_t)0 - (beyond >> 63);
    const uint64_t after = beyond & ~is_within, n = tick - after;
    const uint64_t bent = iso_scaled_product(n * n, t->curve, t->shift);
    return iso_angle_of_turns(n * t->first + ((bent ^ t->sign) - t->sign) + after * t->last);
}

/* Straight lines: line i begins at tick first[i], first[0] = 0, with value[i], and rises by slope[i] in a tick. The
 * last one is level, and no other is 2^32 ticks long. */
typedef struct iso_lines {
    const uint32_t *first;
    const iso_scalar *value, *slope;
    uint32_t count;
} iso_lines;

/* The search takes as many rounds in every tick: a range of n lines is halved until one is left. */
static inline real iso_on_lines(const uint64_t tick, const iso_lines *const t)
{
    uint32_t at = 0;
    for (uint32_t n = t->count; n > 1; n -= n / 2) {
        const uint32_t half = n / 2;
        const uint32_t is_before = (uint32_t)((tick - t->first[at + half]) >> 63);
        at += half & (is_before - 1);
    }
    return iso_all(t->value[at] + t->slope[at] * (iso_scalar)(uint32_t)(tick - t->first[at]));
}

#endif
