/* Numbers at compile time, with the same bits on every host. */
#ifndef ISOC_BASE_NUMBERS_H
#define ISOC_BASE_NUMBERS_H

#include <math.h>
#include <stdbool.h>

#include "tools/isoc/base/arena.h"

/* elementary.c: elementary functions of constants, with the same bits on every host: + - * / and sqrt in pairs of
 * doubles, whose error is below 2^-90 of the result, rounded once. So a result is the nearest double, but where the
 * exact one is within 2^-36 ulp of the middle between two (tests/isoc/scene/language/test_language.py). No host's libm
 * takes part. */

/* |x| <= 700. */
double elementary_exp(double x);

/* x > 0, normal. */
double elementary_log(double x);

/* x^y, for x > 0, normal, and |y log x| <= 700. */
double elementary_power(double x, double y);

/* The angle of the point (x, y) from the x axis, in [-pi, pi]; x and y are not both zero. */
double elementary_atan2(double y, double x);

/* |x| <= 1. */
double elementary_asin(double x);
double elementary_acos(double x);

/* The absolute value of a complex number. */
static inline double modulus(double re, double im)
{
    return sqrt(re * re + im * im);
}

/* eigenvalues.c: the eigenvalues of a matrix, by + - * / and sqrt alone, so that they have the same bits on every host.
 */

/* The largest size of so many numbers. */
double largest_of(const double *v, int count);

/* The eigenvalues of a[n][n] row by row, pairs next to each other: re[n], im[n]. False where the iterations did not
 * end, or an entry is not finite. By scaling to rows and columns of one size (Osborne 1960), Householder's reduction to
 * Hessenberg form and Francis' iteration with two shifts: Golub and Van Loan (2013), Matrix Computations, algorithms
 * 7.4.2, 7.5.1, 7.5.2. */
bool eigenvalues(arena *memory, const double *a, int n, double *re, double *im);

/* least_squares.c: matrices of numbers at compile time, and small systems of any rank. */

/* left[rows][inner] times right[inner][columns], row by row. */
double *product_of_matrices(arena *memory, const double *left, int rows, int inner, const double *right, int columns);

/* a v = u for a[rows][columns] row by row, v orthogonal, and the columns of u across each other, of the lengths
 * `value`: the singular values, in no order. By Hestenes (1958), "Inversion of matrices by biorthogonalization and
 * related results", J. SIAM 6(1). */
typedef struct decomposition {
    int rows, columns;
    double *u, *v, *value;
    double largest; /* value */
} decomposition;

decomposition decompose(arena *memory, const double *a, int rows, int columns);

/* x[columns]: the shortest of the vectors with the least |a x - b|, for a[rows][columns] row by row. Returns the rank
 * of a: the number of singular values above 1e-10 of the largest. */
int least_squares(arena *memory, const double *a, int rows, int columns, const double *b, double *x);

/* principal.c: the principal moments and axes of an inertia, by + - * / and sqrt alone. */

/* The principal moments of a symmetric matrix xx yy zz xy xz yz, and its axes as columns of a rotation. Jacobi's
 * rotations: Golub and Van Loan (2013), Matrix Computations, 8.5. */
void principal_axes(const double inertia[6], double moments[3], double axes[3][3]);

/* real_range.c: the numbers that the plant's type holds: zero, and the normal finite numbers. */

bool real_holds(double number, bool is_double);

/* Whether it is less than the least normal float, but not zero: a float takes it as a factor, scaled by powers of two.
 */
bool real_is_tiny(double number, bool is_double);

/* The advice for a number that the type does not hold: the range, and a remedy. */
const char *real_advice(double number, bool is_double);

#endif
