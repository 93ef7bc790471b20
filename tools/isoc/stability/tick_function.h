/* The functions of the tick as numbers: what the plant's code computes of them, to the rounding of a double. */
#ifndef ISOC_STABILITY_TICK_FUNCTION_H
#define ISOC_STABILITY_TICK_FUNCTION_H

#include "tools/isoc/mechanism/mechanism.h"

/* The value of a node for which is_timed holds, in a tick. */
double tick_function(const mechanism *m, const graph_node *n, uint64_t tick);

#endif
