/* The edges of a quadrature within a tick: a count moves to another one, and each edge comes when a straight line
 * between the two positions passes its count. The next tick plays what this one found. Times are in slots from the
 * begin of the play; no two edges are closer than EDGES_APART of them. */
#ifndef ISO_PORT_PINS_EDGES_H
#define ISO_PORT_PINS_EDGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numbers/real.h"

/* At most so many edges in a tick: a count that moves by more gets the rest in later ticks, and none is lost. */
enum { EDGES_MAX = 64, EDGES_APART = 3 };

typedef struct edges {
    bool is_open;
    int32_t count; /* of the edges that were given out */
    real position; /* of the last call */
} edges;

typedef struct edge {
    uint32_t slot;
    uint32_t levels; /* A in bit 0, B in bit 1, the index in bit 2 */
} edge;

/* A leads B upwards: 00, A, A and B, B. The index is high at the multiples of `turn`. */
static inline uint32_t edges_levels(const int32_t count, const uint32_t turn)
{
    const uint32_t phase = (uint32_t)count & 3;
    const bool is_index = turn > 0 && count % (int32_t)turn == 0;
    return (phase ^ phase >> 1) | (is_index ? 4U : 0U);
}

/* The greatest whole number below a position, which fits. */
static inline int32_t edges_floor(const real position)
{
    const int32_t whole = (int32_t)position;
    return whole - (position < (real)whole);
}

/* How many slots of a period the edges of a tick have: the rest is for the tick that is earlier or later. */
static inline uint32_t edges_slots(const uint32_t period)
{
    return period / 8 * 7;
}

/* The slot of the first edge and the slots between two, in 65536ths: a straight line of so many slots over `span`
 * counts, which passes its first edge after `passed` of them, or has passed it before; all of `number` edges have room.
 */
static inline void edges_line(const real passed, const real span, const int32_t number, const uint32_t slots,
                              uint64_t *const first, uint64_t *const between)
{
    const real size = span < 0 ? -span : span, unit = (real)slots * R(65536.0);
    const real least = number > 1 ? (real)(number - 1) : R(1.0);
    *first = size > 0 ? (uint64_t)(iso_clamp(passed / span, R(0.0), R(1.0)) * unit) : 0;
    *between = (uint64_t)(unit / (size > least ? size : least));
}

/* Writes the edges on the way to a position into list[EDGES_MAX]: over so many slots, in their order. Returns their
 * number. The first call gives the levels that begin. */
static inline size_t edges_to(edges *const e, const real to, const uint32_t turn, const uint32_t slots,
                              edge *const list)
{
    const real limit = R(1073741824.0), position = iso_clamp(to, -limit, limit);
    const int32_t target = edges_floor(position);
    size_t number = 0;
    if (!e->is_open) {
        e->is_open = true;
        e->count = target;
        list[number++] = (edge){.slot = EDGES_APART, .levels = edges_levels(target, turn)};
    } else if (e->count != target) {
        const int32_t step = e->count < target ? 1 : -1, away = step * (target - e->count);
        uint64_t at, between;
        edges_line((real)(e->count + (step > 0)) - e->position, position - e->position,
                   away < EDGES_MAX ? away : EDGES_MAX, slots, &at, &between);
        for (uint32_t least = EDGES_APART; e->count != target && number < EDGES_MAX; number++) {
            const uint32_t slot = (uint32_t)(at >> 16);
            e->count += step;
            list[number] = (edge){.slot = slot < least ? least : slot, .levels = edges_levels(e->count, turn)};
            least = list[number].slot + EDGES_APART;
            at += between;
        }
    }
    e->position = position;
    return number;
}

#endif
