/* The motion of the points that effects and outputs ask for, in the place of the leaves that stand for it; and the
 * forces of effects, from the axes of the ground to those of their segments. */
#ifndef ISOC_TREE_POINT_QUERY_H
#define ISOC_TREE_POINT_QUERY_H

#include "tools/isoc/tree/kinematics.h"

/* The numbers of such a quantity of a point. */
void point_query_nodes(const kinematics *k, const query *q, node parts[QUERY_PARTS]);

void point_queries_resolve(graph *g, mechanism *m);

/* effective_inertia.c: the inertia that mechanisms offer at the start: a joint to an effort on it alone, and a point
 * of a body to a force along one axis alone. Effects derive from it how stiff they can be.
 */

/* Whether any formula asks for one. */
bool asks_for_inertia(const graph *g);

/* The values of the leaves OP_INERTIA, as constants: of each degree of freedom, then three of each point that
 * is asked for (mechanism.h), infinite along an axis along which it cannot move. Closures would make them larger. */
const node *effective_inertias(graph *g, const mechanism *m);

#endif
