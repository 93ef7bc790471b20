/* The periodic loop: wait for a tick, latch the inputs, step, publish the outputs, update the statistics.
 *
 * A tick that came late or was lost is caught up, one step each, so the trajectory depends on the count of ticks only
 * and never on their timing. Step k goes from (k - 1) h to k h with the inputs of (k - 1) h.
 */
#ifndef ISO_CORE_RUNTIME_LOOP_H
#define ISO_CORE_RUNTIME_LOOP_H

#include <stdbool.h>

#include "core/runtime/plant.h"

#define iso_loop_start ISO_REAL_NAME(iso_loop_start)
#define iso_loop_tick ISO_REAL_NAME(iso_loop_tick)

/* A tick that starts more than a period / 2^ISO_LATE_SHIFT after it was due is late. */
enum { ISO_LATE_SHIFT = 4 };

/* How the ticks kept their time. Times are in counts of the port's clock. Counts and times have 64 bits: none wraps in the
 * life of a machine, and a stall of any length is booked as long as it was. */
typedef struct iso_statistics {
    uint64_t ticks;         /* done */
    uint64_t late;          /* of them, started late */
    uint64_t lost;          /* of them, reported by the port only with a later one */
    uint64_t overruns;      /* of them, ended after the next one was due */
    uint64_t restarts;      /* of them, with a new history of the method, after a discontinuity */
    uint64_t violated;      /* ticks that ended with a violation above the limit of the plant */
    int64_t margin;         /* the least time left when the outputs were published; positive is good */
    uint64_t execution_min; /* of a step without a restart */
    uint64_t execution_max;
    uint64_t execution_sum;
    uint64_t restart_max;    /* of a step with a restart, including the restart */
    iso_refusals inputs;     /* that were not finite or beyond their limits, */
    iso_refusals parameters; /* likewise */
    uint64_t outputs_held;   /* ticks in which an output was not finite: the last good ones were published */
    real local_error;        /* the largest of all steps, where steps are checked */
    real violation;          /* the largest of all ticks */
} iso_statistics;

typedef struct iso_loop {
    const iso_plant *plant;
    uint64_t tick;     /* steps done: the plant's time is tick times its step */
    uint64_t reported; /* the latest tick that the port reported */
    uint64_t due;      /* when tick was due, on the port's clock */
    uint32_t period;   /* counts */
    uint32_t overhead; /* counts of reading the clock */
    uint16_t guard;    /* the first state that is not finite or out of range; plant->model->states if there is none */
    iso_statistics statistics;
} iso_loop;

/* Sets the plant to its start, publishes its outputs of tick 0, and starts the ticks. */
void iso_loop_start(iso_loop *loop, const iso_plant *plant);

/* Does the next tick. Returns false if a state is no longer finite, or out of range: then the outputs stay as they
 * were, nothing is published or counted, the port is put into its safe state, and loop->guard and loop->tick name the state
 * and the tick. */
bool iso_loop_tick(iso_loop *loop);

#endif
