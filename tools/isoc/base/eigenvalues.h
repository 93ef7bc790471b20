/* The eigenvalues of a matrix, by + - * / and sqrt alone, so that they have the same bits on every host. */
#ifndef ISOC_BASE_EIGENVALUES_H
#define ISOC_BASE_EIGENVALUES_H

#include <stdbool.h>

#include "tools/isoc/base/arena.h"

/* Those of a[n][n] row by row, pairs next to each other: re[n], im[n]. False where the iterations did not end, or an
 * entry is not finite. By scaling to rows and columns of one size (Osborne 1960), Householder's reduction to Hessenberg
 * form and Francis' iteration with two shifts: Golub and Van Loan (2013), Matrix Computations,
 * algorithms 7.4.2, 7.5.1, 7.5.2. */
bool eigenvalues(arena *memory, const double *a, int n, double *re, double *im);

#endif
