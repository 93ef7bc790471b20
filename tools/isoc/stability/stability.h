/* Whether the method holds the plant with its step: eigenvalues of the Jacobian against the method's region. */
#ifndef ISOC_STABILITY_STABILITY_H
#define ISOC_STABILITY_STABILITY_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* At the start, and there with all joints at rest, and from both at the steepest points of each effect: warns of what makes a
 * motion grow by the method alone, one after the other, at the first of these that shows some; notes a Jacobian that is not finite, where the method needs it. A plant of more than 60 states is not looked at,
 * nor the sub-steps of adams, which follow their error. */
void stability_check(source *s, const graph *g, const plant *p);

#endif
