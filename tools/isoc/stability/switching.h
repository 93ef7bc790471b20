/* Whether an effect switches faster than the step follows: a discontinuity within a step is misplaced by up to half of it,
 * whatever the order of the method. */
#ifndef ISOC_STABILITY_SWITCHING_H
#define ISOC_STABILITY_SWITCHING_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Follows the motion from the start, for up to 10 s or a bounded number of operations, and warns of each effect whose
 * formulas jump so often that half a step at each jump is more than 1 % of what they give. Not looked at are
 * implicit methods, whose plant an explicit look does not follow, adams, and plants that read a memory in their equations. */
void switching_check(const source *s, const graph *g, const plant *p);

#endif
