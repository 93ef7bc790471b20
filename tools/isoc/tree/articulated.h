/* The accelerations of a tree of segments by articulated bodies, as nodes.
 *
 * Featherstone (1983), "The calculation of robot dynamics using articulated-body inertias", Int. J. Robotics Research
 * 2(1); (2008), Rigid Body Dynamics Algorithms, ch. 7. In segment frames, about segment origins, with accelerations of
 * points in place of spatial ones, so that no velocity of an origin is needed. The cost grows with the number of
 * segments; factorising a mass matrix (tools/isoc/tree/mass_matrix.h) costs less for few segments, and grows with a
 * higher power.
 */
#ifndef ISOC_TREE_ARTICULATED_H
#define ISOC_TREE_ARTICULATED_H

#include "tools/isoc/tree/wrench.h"

/* From x = efforts to x = q''. [degrees of freedom] */
void articulated_solve(const kinematics *k, node *x);

#endif
