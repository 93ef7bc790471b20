/* The runs of a sweep, in this process. */
#ifndef SWEEP_RUN_H
#define SWEEP_RUN_H

#include <stdio.h>

#include "core/runtime/plant.h"
#include "tools/sweep/plan.h"

/* A plant of the sweep, or the message with which isoc refused it. Its start, if it differs from another plant, whose
 * code it uses, in the start only; else NULL. */
typedef struct sweep_plant {
    const iso_plant *plant;
    const char *refusal;
    const iso_scalar *start;
} sweep_plant;

/* All plants, and the duration of each run: tools/sweep/sweep.sh writes them. */
extern const sweep_plant sweep_plants[];
extern const uint64_t sweep_duration_ns;

/* Ends the program if a plant is not as the plan has it. */
void run_check(const plan *p);

/* Writes the rows of the runs from `first` up to before `end`. */
void run_rows(const plan *p, uint64_t first, uint64_t end, FILE *to);

#endif
