/* The table of a sweep, of its parts. */
#ifndef SWEEP_TABLE_H
#define SWEEP_TABLE_H

#include "tools/sweep/plan.h"

/* Writes sweep.tsv, columns.tsv and failures.txt into the folder, and prints a summary of them. `again` begins the
 * command that makes a run alone. */
void table_make(const plan *p, const char *folder, const char *again);

#endif
