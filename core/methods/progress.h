/* The report of a method on its steps. It is a part of the plant's memory, so this header is C and C++. */
#ifndef ISO_CORE_METHODS_PROGRESS_H
#define ISO_CORE_METHODS_PROGRESS_H

#include <stdbool.h>

#include "core/numbers/real.h"

/* Of a run, besides its state. Here and below, `unused` fills up to where every compiler would: a plant's memory has
 * the same bytes on every target. */
typedef struct iso_progress {
    real local_error;       /* the largest of any state: of this step, or of the one before; 0 if it is not checked */
    real residual;          /* of the last Newton iteration */
    real usual;             /* local error, if discontinuities are detected: iso_watch */
    iso_steps watched;      /* steps, up to ISO_USUAL_STEPS */
    iso_flag discontinuity; /* a discontinuity in this step: the history and the step are invalid */
    iso_rest unused;
} iso_progress;

/* The progress of adams: that of any method, then its own. Zeros before the first start. */
typedef struct iso_adams_state {
    iso_progress progress;
    uint8_t order;
    uint8_t level;
    uint8_t age;   /* corrections of this order and level, up to 255, including one from before the level changed */
    bool starting; /* the order grows as soon as possible */
    bool overdue;  /* the step is too large, but the budget did not allow a smaller one */
    uint8_t unused[sizeof(real) - 1];
    uint32_t substeps;     /* accepted */
    uint32_t rejected;     /* tried, and too large */
    uint32_t budget_bound; /* of those accepted: with an error above the tolerance, because of budget or level_max */
    uint32_t restarts;     /* after discontinuities */
    uint32_t evaluations;
} iso_adams_state;

/* Whether steps came near a singular position of closed loops: iso_watch_pivots. Zeros before the first start. */
typedef struct iso_nearness {
    iso_count
        closure;     /* 0: none did; else 1 and the closure of the last that did, until the reader of it sets it to 0 */
    iso_count known; /* all ones where the pivots before a step are known, else 0 */
} iso_nearness;

/* The energy that steps near a singular position keep: iso_hold_energy. Zeros before the first start. */
typedef struct iso_held_energy {
    real energy;   /* J, behind the last step that was not near, nor after one */
    iso_bits near; /* all ones where the last step was near, else 0 */
} iso_held_energy;

/* Events of a run (core/methods/event.h): those that fired, and those of them that had to wait for a later step. */
typedef struct iso_event_counts {
    iso_count fired;
    iso_count late;
} iso_event_counts;

/* Of any method. */
typedef union iso_any_progress {
    iso_progress progress;
    iso_adams_state adams;
} iso_any_progress;

#endif
