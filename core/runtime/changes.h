/* Tunables that are set at ticks that are known: a table in the order of time, of which a plant keeps its place. What
 * is due follows from the number of the tick alone; a tick in which nothing is due costs one comparison, however long
 * the table is. */
#ifndef ISO_CORE_RUNTIME_CHANGES_H
#define ISO_CORE_RUNTIME_CHANGES_H

#include "core/numbers/real.h"

/* The value of a parameter from a tick on. */
typedef struct iso_change {
    uint32_t tick;
    uint32_t parameter;
    iso_scalar value;
} iso_change;

/* The first place of all[count] that is not before the tick: where a plant goes on that did not come from the tick
 * before. */
static inline uint32_t iso_place_of_changes(const iso_change *const all, const uint32_t count, const uint64_t tick)
{
    uint32_t place = 0;
    for (uint32_t left = count; left > 0;) {
        const uint32_t half = left / 2;
        if (all[place + half].tick < tick) {
            place += half + 1;
            left -= half + 1;
        } else {
            left = half;
        }
    }
    return place;
}

/* Sets p by all that is due in the tick, in the order of the table. Returns the place behind that. */
static inline uint32_t iso_set_due(real *const p, const iso_change *const all, const uint32_t count, uint32_t place,
                                   const uint64_t tick)
{
    while (place < count && all[place].tick == tick) {
        p[all[place].parameter] = iso_all(all[place].value);
        place++;
    }
    return place;
}

#endif
