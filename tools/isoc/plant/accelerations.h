/* The specific forces that outputs and memories ask for: what an accelerometer at a point of a body measures, its
 * acceleration less that of gravity. */
#ifndef ISOC_PLANT_ACCELERATIONS_H
#define ISOC_PLANT_ACCELERATIONS_H

#include "tools/isoc/plant/plant.h"

/* Puts them in the place of the leaves that stand for them. */
void specific_forces_resolve(plant *p, graph *g);

#endif
