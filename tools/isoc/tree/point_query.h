/* The motion of the points that effects and outputs ask for, in the place of the leaves that stand for it; and the forces
 * of effects, from the axes of the ground to those of their segments. */
#ifndef ISOC_TREE_POINT_QUERY_H
#define ISOC_TREE_POINT_QUERY_H

#include "tools/isoc/tree/kinematics.h"

/* The numbers of such a quantity of a point. */
void point_query_nodes(const kinematics *k, const query *q, node parts[QUERY_PARTS]);

void point_queries_resolve(graph *g, mechanism *m);

#endif
