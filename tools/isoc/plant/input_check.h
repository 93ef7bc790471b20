/* Warns where held inputs lower the order of a method: a method with a history takes what it is given for
 * samples of a smooth curve. */
#ifndef ISOC_PLANT_INPUT_CHECK_H
#define ISOC_PLANT_INPUT_CHECK_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Warns of the first input that is held where the method has a history, or whose extrapolation the local error does not see;
 * and of the first function of time in a formula that the derivative depends on, by itself or through memories: noise, say. */
void samples_check(const source *s, const graph *g, const scene *written, const plant *p);

#endif
