/* The parts of a sweep: files that are whole or absent, and how far they are. */
#ifndef SWEEP_PARTS_H
#define SWEEP_PARTS_H

#include <sys/types.h>

#include "tools/sweep/plan.h"

/* Makes a part; leaves one that is there alone. */
void part_make(const plan *p, uint64_t part);

/* Makes all parts that are absent, in so many processes, and shows the progress. Returns how many are absent then. */
uint64_t parts_make(const plan *p, unsigned processes);

/* Shows the progress of parts that another process makes, as long as that runs. Returns how many are absent then. */
uint64_t parts_watch(const plan *p, pid_t engine);

#endif
