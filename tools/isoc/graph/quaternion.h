/* Orientation by a unit quaternion (w, x, y, z), as Euler's parameters: cos(a/2), axis sin(a/2).
 *
 * Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 6.
 */
#ifndef ISOC_GRAPH_QUATERNION_H
#define ISOC_GRAPH_QUATERNION_H

#include "tools/isoc/graph/vector.h"

/* The turn from turned to unturned coordinates. */
matrix quaternion_matrix(graph *g, const node q[4]);

/* The same, which a length of 1 + e changes by some e^2 only: beside the unit quaternions, too, it is a turn, and it has
 * no derivative by the length. */
matrix quaternion_matrix_of_any(graph *g, const node q[4]);

/* a b: first the turn b, then a. `product` may be a or b. */
void quaternion_product(graph *g, const node a[4], const node b[4], node product[4]);

/* q' = 1/2 q (0, omega), with omega in turned coordinates. It leaves the norm as it is. */
void quaternion_rates(graph *g, const node q[4], const node omega[3], node rates[4]);

/* q (3 - |q|^2) / 2, one step of Newton's method for 1 / |q|: of a norm 1 + e it makes 1 - 3/2 e^2, without a branch.
 */
void quaternion_normalise(graph *g, const node q[4], node normed[4]);

/* The same as the change of q, of which rounding then takes a part instead of one of q. */
void quaternion_lengthening(graph *g, const node q[4], node change[4]);

/* The quaternion of a constant turn (Shepperd 1978, Quaternion from rotation matrix, J. Guidance and Control 1(3)). */
void quaternion_of_matrix(double r[3][3], double q[4]);
void quaternion_of_constant(graph *g, matrix r, node q[4]);

#endif
