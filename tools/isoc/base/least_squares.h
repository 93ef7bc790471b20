/* Small systems of numbers, of any rank, at compile time. */
#ifndef ISOC_BASE_LEAST_SQUARES_H
#define ISOC_BASE_LEAST_SQUARES_H

#include "tools/isoc/base/arena.h"

/* x[columns]: the shortest of those that leave the least of |a x - b|, for a[rows][columns] row by row. Returns the
 * rank of a: the number of singular values above 1e-10 of the largest. By the singular value decomposition of Hestenes
 * (1958), "Inversion of matrices by biorthogonalization and related results", J. SIAM 6(1). */
int least_squares(arena *memory, const double *a, int rows, int columns, const double *b, double *x);

#endif
