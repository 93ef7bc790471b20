/* The equations at the start, as the plant computes them. */
#ifndef ISOC_PLANT_CHECK_START_H
#define ISOC_PLANT_CHECK_START_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Notes why the derivative at the start is not finite in the plant's own real: a closure that is lost by rounding, or a
 * joint whose derivative overflows. */
void start_check(source *s, const graph *g, const plant *p);

#endif
