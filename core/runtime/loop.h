/* The periodic loop: wait for a tick, latch the inputs, step, publish the outputs, update the statistics.
 *
 * A tick that came late or was lost is caught up, one step each, so the trajectory depends on the count of ticks only
 * and never on their timing. Step k goes from (k - 1) h to k h with the inputs of (k - 1) h.
 */
#ifndef ISO_CORE_RUNTIME_LOOP_H
#define ISO_CORE_RUNTIME_LOOP_H

#include <stdbool.h>

#include "core/runtime/plant.h"
#include "core/runtime/statistics.h"

#define iso_loop_start ISO_REAL_NAME(iso_loop_start)
#define iso_loop_tick ISO_REAL_NAME(iso_loop_tick)
#define iso_loop_begin ISO_REAL_NAME(iso_loop_begin)
#define iso_loop_end ISO_REAL_NAME(iso_loop_end)
#define iso_loop_rest ISO_REAL_NAME(iso_loop_rest)
#define iso_loop_pass ISO_REAL_NAME(iso_loop_pass)
#define iso_loop_restart ISO_REAL_NAME(iso_loop_restart)
#define iso_loop_jump ISO_REAL_NAME(iso_loop_jump)

/* A tick is late if its step begins more than a period / 2^ISO_LATE_SHIFT after it was due, with its inputs read. */
enum { ISO_LATE_SHIFT = 4 };

/* The counters of time, when two ticks rest to be done after five that are, and three passed while the plant rested:
 *
 *     the port's ticks    1 2 3   4 5 6 7 8   9 10
 *                         rested  done        to be done
 *     rested = 3, tick = 5, reported = 7; due is the clock at the port's tick 8.
 */
typedef struct iso_loop {
    const iso_plant *plant;
    uint64_t tick;     /* steps done: the plant's time is tick times its step */
    uint64_t rested;   /* ticks of the port that passed without a step; less, modulo 2^64, those of a jump ahead */
    uint64_t reported; /* the latest tick that the port reported, less those: tick, if none is to be caught up */
    uint64_t due;      /* when tick + rested was due, on the port's clock */
    uint32_t period;   /* counts */
    uint32_t overhead; /* counts of reading the clock */
    uint16_t at_once;  /* outputs that are published when they are computed: all, or 0 where the next tick does */
    uint16_t guard;    /* the first bad state, or `states` of the model: iso_plant_guard */

    /* Within these bounds of the statistics a tick has no news: the time from when it was due to its end, at most; and
     * the execution of its step. */
    uint32_t used;
    uint32_t execution_min;
    uint32_t execution_max;
    iso_statistics statistics;
} iso_loop;

/* Sets the plant to its start, publishes its outputs of tick 0, and starts the ticks. */
void iso_loop_start(iso_loop *loop, const iso_plant *plant);

/* Does the next tick. Returns false if a state is no longer finite, or out of range: then the outputs stay as they
 * were, nothing is published or counted, the port is put into its safe state, and loop->guard and loop->tick name the
 * state and the tick. Returns false also if a policy ends the run with this tick: then it is whole, and loop->guard
 * names no state. */
bool iso_loop_tick(iso_loop *loop);

/* The two parts of iso_loop_tick, for a program that sets inputs between them by other means than iso_port_read. The
 * first waits for the tick, and sets the inputs that are functions of time; the second does the rest. */
void iso_loop_begin(iso_loop *loop);
bool iso_loop_end(iso_loop *loop);

/* The plant rests: waits for the next tick of the port; it, and all that were to be caught up, pass without a step, and
 * count neither as lost nor as late. */
void iso_loop_rest(iso_loop *loop);

/* Between two ticks: so many ticks of the port, which came since the last one was done, pass without a step, and count
 * neither as lost nor as late. */
void iso_loop_pass(iso_loop *loop, uint64_t ticks);

/* Rests for a tick; then sets the plant to its start, publishes its outputs of tick 0, and begins the account anew. */
void iso_loop_restart(iso_loop *loop);

/* Between two ticks, when the plant's memory has become that of another tick: goes on from there. Publishes its outputs
 * as they are; the port's ticks and the account go on. */
void iso_loop_jump(iso_loop *loop, uint64_t tick);

#endif
