/* Whether the method holds the plant with its step: eigenvalues of the Jacobian against the method's region. */
#ifndef ISOC_STABILITY_STABILITY_H
#define ISOC_STABILITY_STABILITY_H

#include "tools/isoc/plant/plant.h"

/* Looks at the start, at the start with all joints at rest, and from both at the steepest points of each effect. At the
 * first of these where a motion grows by the method alone, warns of each cause, one after the other. Notes a Jacobian
 * that is not finite, where the method needs it. A plant of more than 60 states is not checked, nor the sub-steps of
 * adams, which follow their error. */
void stability_check(source *s, const graph *g, const plant *p);

/* switching.c: whether an effect switches faster than the step follows: a discontinuity within a step is misplaced by
 * up to half of it, whatever the order of the method. Follows the motion from the start, for up to 10 s or a bounded
 * number of operations, and warns of each effect whose formulas jump so often that half a step at each jump is more
 * than 1 % of their value. Not checked are implicit methods, whose plant an explicit step does not follow, adams, and
 * plants that read a memory in their equations. */
void switching_check(const source *s, const graph *g, const plant *p);

#endif
