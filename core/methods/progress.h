/* What a method tells of its steps. It is a part of the plant's memory, so that this header is C and C++. */
#ifndef ISO_CORE_METHODS_PROGRESS_H
#define ISO_CORE_METHODS_PROGRESS_H

#include <stdbool.h>

#include "core/numbers/real.h"

/* How a run goes, beside its state. */
typedef struct iso_progress {
    real local_error; /* the largest of any state: of this step, or of the one before; 0 if it is not checked */
    real residual;    /* of the last Newton iteration */
    real usual;       /* local error, where jumps are watched for: iso_watch */
    uint8_t watched;  /* steps, up to ISO_USUAL_STEPS */
    bool jumped;      /* the motion did, in this step: what the method keeps is of no use, nor is the step */
} iso_progress;

/* How a run of adams goes: what any method tells, and then what adams alone does. Zeros before the first start. */
typedef struct iso_adams_state {
    iso_progress progress;

    uint8_t order;
    uint8_t level;
    uint8_t age; /* corrections of this order and level, up to 255; one from before the level changed counts as well */
    bool starting; /* the order grows as soon as it can */
    bool overdue;  /* the step is too large, but the budget did not allow a smaller one */

    uint32_t substeps;     /* taken */
    uint32_t rejected;     /* tried, and found to be too large */
    uint32_t budget_bound; /* of those taken: with an error above the tolerance, as budget or level_max wanted it */
    uint32_t restarts;     /* since the derivative jumped */
    uint32_t evaluations;
} iso_adams_state;

/* Of any method. */
typedef union iso_any_progress {
    iso_progress progress;
    iso_adams_state adams;
} iso_any_progress;

#endif
