/* Vectors and matrices of nodes: the algebra of 3-D mechanics, written once. */
#ifndef ISOC_GRAPH_VECTOR_H
#define ISOC_GRAPH_VECTOR_H

#include "tools/isoc/graph/graph.h"

typedef struct vector {
    node at[3];
} vector;

typedef struct matrix {
    node at[3][3]; /* row, column */
} matrix;

/* A symmetric matrix, e.g. an inertia tensor. */
typedef struct tensor {
    node xx, yy, zz, xy, xz, yz;
} tensor;

vector vector_zero(graph *g);
vector vector_of(graph *g, double x, double y, double z);
vector vector_add(graph *g, vector a, vector b);
vector vector_sub(graph *g, vector a, vector b);
vector vector_scale(graph *g, node s, vector a);
vector vector_cross(graph *g, vector a, vector b);
node vector_dot(graph *g, vector a, vector b);
vector vector_name(graph *g, vector a, const char *quantity, const char *owner);
bool vector_is_constant(const graph *g, vector a);

matrix matrix_identity(graph *g);
matrix matrix_product(graph *g, matrix a, matrix b);
matrix matrix_transpose(matrix a);
matrix matrix_add(graph *g, matrix a, matrix b);
vector matrix_apply(graph *g, matrix a, vector b);
vector matrix_column(matrix a, int column);

/* A constant matrix with the entries that rounding left near 0 and +-1 (within 4 ulp of 1) put right, so that a turn
 * by 90 degrees costs nothing. */
matrix matrix_snap(graph *g, matrix a);

/* The turn by an angle (sine s, cosine c) about coordinate axis k: from turned to unturned coordinates, and back. */
vector turn_out(graph *g, int k, node s, node c, vector a);
vector turn_in(graph *g, int k, node s, node c, vector a);

/* R A R' for a matrix R, and for a turn about coordinate axis k. */
matrix matrix_rotate(graph *g, matrix r, matrix a);
matrix matrix_turn_out(graph *g, int k, node s, node c, matrix a);

matrix tensor_matrix(tensor a);
tensor matrix_tensor(matrix m);
tensor tensor_zero(graph *g);
tensor tensor_add(graph *g, tensor a, tensor b);
vector tensor_apply(graph *g, tensor a, vector b);

/* R J R' */
tensor tensor_rotate(graph *g, matrix r, tensor j);

/* The inertia about the origin of a body that is moved by p, from its mass and from its first moment ms and inertia j
 * about the origin before. */
tensor tensor_shift(graph *g, tensor j, node mass, vector ms, vector p);

/* quaternion.c: orientation by a unit quaternion (w, x, y, z), as Euler's parameters: cos(a/2), axis sin(a/2).
 *
 * Nikravesh (1988), Computer-Aided Analysis of Mechanical Systems, ch. 6.
 */

/* The turn from turned to unturned coordinates. */
matrix quaternion_matrix(graph *g, const node q[4]);

/* The same, which a length of 1 + e changes by some e^2 only: beside the unit quaternions, too, it is a turn, and it
 * has no derivative by the length. */
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
