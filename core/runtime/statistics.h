/* The counts of the loop. */
#ifndef ISO_CORE_RUNTIME_STATISTICS_H
#define ISO_CORE_RUNTIME_STATISTICS_H

#include "core/runtime/admit.h"

/* How the ticks kept their time. Times are in counts of the port's clock. Counts and times have 64 bits: none wraps in
 * the life of a machine, and a stall of any length is booked as long as it was. */
typedef struct iso_statistics {
    uint64_t ticks;         /* done */
    uint64_t late;          /* of them, whose step began late: ISO_LATE_SHIFT (core/runtime/loop.h) */
    uint64_t lost;          /* of them, reported by the port only with a later one */
    uint64_t overruns;      /* of them, ended after the next one was due */
    uint64_t restarts;      /* of them, with a new history of the method, after a discontinuity */
    uint64_t violated;      /* ticks that ended with a violation above the limit of the plant */
    int64_t margin;         /* the least time left when the outputs were published; positive is good */
    uint64_t execution_min; /* of a step without a restart */
    uint64_t execution_max;
    uint64_t execution_sum;
    uint64_t restart_max;           /* of a step with a restart, including the restart */
    iso_refusals inputs;            /* that were not finite or beyond their limits */
    iso_refusals parameters;        /* likewise */
    uint64_t outputs_held;          /* ticks in which an output was not finite: the last good ones were published */
    uint64_t near_singular;         /* ticks with a step near a singular position of closures (core/methods/pivots.h) */
    uint64_t near_singular_first;   /* the first of them */
    uint64_t near_singular_closure; /* the closure of the first, from 0 */
    uint64_t events;                /* of the scene that fired (core/methods/event.h) */
    uint64_t late_events;           /* that waited for the begin of the next step, as another came first */
    real local_error;               /* the largest of all steps, where steps are checked */
    real violation;                 /* the largest of all ticks */
} iso_statistics;

#endif
