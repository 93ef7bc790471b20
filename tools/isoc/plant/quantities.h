/* The nodes of quantities: of those that outputs show, and of those that formulas ask for and that are known with the
 * accelerations, or after a step. */
#ifndef ISOC_PLANT_QUANTITIES_H
#define ISOC_PLANT_QUANTITIES_H

#include "tools/isoc/dynamics/reaction.h"
#include "tools/isoc/plant/plant.h"

/* The numbers of a quantity. */
void quantity_nodes(plant *p, graph *g, const query *q, node parts[QUERY_PARTS]);

/* Puts those that are known late in the place of the leaves that stand for them. */
void late_queries_resolve(plant *p, graph *g);

#endif
