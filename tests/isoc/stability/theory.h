/* Where methods are stable, from published coefficients and formulas alone, without a kernel: x' = lambda x, z = h
 * lambda.
 *
 * A multistep method turns x' = lambda x into a recurrence, whose characteristic polynomial in zeta has coefficients
 * linear or more in z; a one-step method multiplies x by R(z). Growth per step is the largest |zeta|, or |R(z)|. Hairer
 * and Wanner (1996), Solving Ordinary Differential Equations II, IV.2, IV.7 and V.1.
 */
#ifndef ISO_TESTS_STABILITY_THEORY_H
#define ISO_TESTS_STABILITY_THEORY_H

#include <complex.h>

/* The imaginary unit in double. */
#define IMAGINARY ((double complex)I)

/* The growth per step of a method at z: of x' = lambda x; for semi_implicit of q'' = 2 re z q' - |z|^2 q, or on the
 * real axis of v' = z v; for adams of its highest order at an even step. NaN where nothing is published here. */
double theory_growth(unsigned method, double complex z);

#endif
