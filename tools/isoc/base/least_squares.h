/* Small systems of numbers, of any rank, at compile time. */
#ifndef ISOC_BASE_LEAST_SQUARES_H
#define ISOC_BASE_LEAST_SQUARES_H

#include "tools/isoc/base/arena.h"

/* a v = u for a[rows][columns] row by row, v orthogonal, and the columns of u across each other, of the lengths
 * `value`: the singular values, in no order. By Hestenes (1958), "Inversion of matrices by biorthogonalization and
 * related results", J. SIAM 6(1). */
typedef struct decomposition {
    int rows, columns;
    double *u, *v, *value;
    double largest; /* value */
} decomposition;

decomposition decompose(arena *memory, const double *a, int rows, int columns);

/* x[columns]: the shortest of those that leave the least of |a x - b|, for a[rows][columns] row by row. Returns the
 * rank of a: the number of singular values above 1e-10 of the largest. */
int least_squares(arena *memory, const double *a, int rows, int columns, const double *b, double *x);

#endif
