/* What is known with the accelerations, where outputs and memories ask for it: what an accelerometer at a point of a body
 * measures, its acceleration less that of gravity; and what joints and closures give to their children. */
#ifndef ISOC_PLANT_ACCELERATIONS_H
#define ISOC_PLANT_ACCELERATIONS_H

#include "tools/isoc/dynamics/reaction.h"
#include "tools/isoc/plant/plant.h"

/* Of the joint of this child, or of a closure where `loop` is one, and not -1. */
wrench reaction_of(plant *p, graph *g, int child, int loop);

/* Puts all that is asked for in the place of the leaves that stand for it. */
void accelerations_resolve(plant *p, graph *g);

#endif
