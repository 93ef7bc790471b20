/* The principal moments and axes of an inertia, by + - * / and sqrt alone. */
#ifndef ISOC_BASE_PRINCIPAL_H
#define ISOC_BASE_PRINCIPAL_H

/* Of a symmetric matrix xx yy zz xy xz yz: its moments, and the axes as columns of a rotation. Jacobi's rotations:
 * Golub and Van Loan (2013), Matrix Computations, 8.5. */
void principal_axes(const double inertia[6], double moments[3], double axes[3][3]);

#endif
