/* The equations at the start, as the plant computes them. */
#ifndef ISOC_PLANT_START_H
#define ISOC_PLANT_START_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Notes what makes the derivative at the start no number in the plant's own real: a closure that its rounding loses, or
 * a joint whose derivative overflows. */
void start_check(source *s, const graph *g, const plant *p);

#endif
