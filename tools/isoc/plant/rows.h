/* The assignments of a row in their order: the functions of time, then the memories, then the outputs. Row k is the time k h.
 *
 *     functions of time that a memory or an output reads, at the row
 *     what previous and delay show: what was kept in an earlier row
 *     samples that a next reads
 *     all memories of effects, by their next
 *     all other samples, of the memories as they are now
 *     what previous and delay will show: what their formulas are in this row
 *
 * At the start states and memories of effects get their starts, each after what it reads, and so do the samples and the pasts.
 */
#ifndef ISOC_PLANT_ROWS_H
#define ISOC_PLANT_ROWS_H

#include "tools/isoc/plant/plant.h"

/* Sets p->rows, and the starts as numbers, functions of time counting as zero. Of what is left of a plant `whole` is the
 * plant with all effects, whose functions of time it sees; else NULL. Notes a start or a sample that needs itself. */
void rows_build(source *s, graph *g, plant *p, const plant *whole);

#endif
