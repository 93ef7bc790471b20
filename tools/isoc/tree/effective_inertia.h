/* The inertia that mechanisms offer at the start: a joint to an effort on it alone, and a point of a body to a force along
 * one axis alone. Effects derive from it how stiff they can be.
 */
#ifndef ISOC_TREE_EFFECTIVE_INERTIA_H
#define ISOC_TREE_EFFECTIVE_INERTIA_H

#include "tools/isoc/tree/kinematics.h"

/* Whether any formula asks for one. */
bool asks_for_inertia(const graph *g);

/* The values of the leaves OP_INERTIA, as constants: of each degree of freedom, then three of each point that
 * is asked for (mechanism.h), infinite along an axis along which it cannot move. Closures would make them larger. */
const node *effective_inertias(graph *g, const mechanism *m);

#endif
