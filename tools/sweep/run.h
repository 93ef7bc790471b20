/* The runs of a sweep, in this process. */
#ifndef SWEEP_RUN_H
#define SWEEP_RUN_H

#include <stdio.h>

#include "tools/sweep/plan.h"

/* Ends the program if a plant is not as the plan has it. */
void run_check(const plan *p);

/* Writes the rows of the runs from `first` up to before `end`. */
void run_rows(const plan *p, uint64_t first, uint64_t end, FILE *to);

#endif
