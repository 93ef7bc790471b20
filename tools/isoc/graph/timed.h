/* What functions of the tick are given in core: phases, and the table of a sweep. isoc evaluates them and writes them
 * as C from the same numbers. */
#ifndef ISOC_GRAPH_TIMED_H
#define ISOC_GRAPH_TIMED_H

#include "core/numbers/waveform.h"
#include "tools/isoc/graph/graph.h"

/* Turns as a phase, without the whole ones: 2^64 is one. */
uint64_t phase_of(double turns);

iso_chirp_table sweep_of(const tick_table *t);

#endif
