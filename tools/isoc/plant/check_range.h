/* The constants of a plant's equations. */
#ifndef ISOC_PLANT_CHECK_RANGE_H
#define ISOC_PLANT_CHECK_RANGE_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Notes a constant that the plant's type cannot hold: a product of numbers that it can, such as a mass and a square of
 * a length. */
void range_check(source *s, const graph *g, const plant *p);

#endif
