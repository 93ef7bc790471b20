/* The times of whole ticks, and of what a run does between them: it writes rows, and its hash. Ticks of the port that
 * come meanwhile pass without a step, so that only the plant itself makes a tick late. */
#ifndef ISO_CORE_APPLICATION_TIMES_H
#define ISO_CORE_APPLICATION_TIMES_H

#include "core/runtime/loop.h"
#include "port/port.h"

/* In counts of the port's clock. */
typedef struct iso_times {
    uint64_t tick_min, tick_max; /* from when a tick was due to its end; 0 in virtual time */
    uint64_t beside;             /* all that was done between ticks */
    uint64_t done;               /* when the last tick was done */
    uint64_t next;               /* when the first tick of the port after that is due */
} iso_times;

/* A tick is done. */
static inline void iso_times_done(iso_times *const times, const iso_loop *const loop)
{
    times->done = iso_port_clock();
    const uint64_t tick = times->done - loop->due;
    times->tick_min = tick < times->tick_min || times->tick_max == 0 ? tick : times->tick_min;
    times->tick_max = tick > times->tick_max ? tick : times->tick_max;
    while (times->next <= times->done) {
        times->next += loop->period;
    }
}

/* The work between two ticks is done. Ticks of the port that came meanwhile pass without a step. If the work took time,
 * so does a tick that comes within the time by which one is late (ISO_LATE_SHIFT). */
static inline void iso_times_go_on(iso_times *const times, iso_loop *const loop)
{
    const uint64_t now = iso_port_clock();
    uint64_t passed = 0;
    times->beside += now - times->done;
    const uint64_t soon = now > times->done ? now + (loop->period >> ISO_LATE_SHIFT) : now;
    while (times->next <= soon) {
        times->next += loop->period;
        passed++;
    }
    while (passed > 0 && iso_port_clock() + loop->period < times->next) {
        /* until the last of them has come: the port would report one fewer */
    }
    iso_loop_pass(loop, passed);
}

#endif
