/* A graph whose values are computed at the scales that tools/isoc/scales.h chooses. */
#ifndef ISOC_RESCALE_H
#define ISOC_RESCALE_H

#include "tools/isoc/graph.h"

/* The nodes that `count` roots need, in the same order, in a graph of their own; made[count] are the roots there. What
 * is a multiple of its quantity says so in its name. */
graph rescale(const graph *g, const node *roots, size_t count, node *made);

#endif
