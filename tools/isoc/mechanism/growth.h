/* Where methods are stable, from their coefficients alone: x' = lambda x, z = h lambda.
 *
 * A multistep method turns x' = lambda x into a recurrence, whose characteristic polynomial in zeta has coefficients
 * linear or more in z; a one-step method multiplies x by R(z). Growth per step is the largest |zeta|, or |R(z)|. Hairer
 * and Wanner (1996), Solving Ordinary Differential Equations II, IV.2, IV.7 and V.1.
 */
#ifndef ISOC_MECHANISM_GROWTH_H
#define ISOC_MECHANISM_GROWTH_H

#include <complex.h>

/* The imaginary unit in double. */
#define GROWTH_I ((double complex)I)

/* The growth per step of a recipe's method at z: of x' = lambda x; for semi_implicit of q'' = lambda^2 q on the
 * imaginary axis and of q' = v, v' = lambda v on the real one. */
double growth_of(unsigned recipe, double complex z);

#endif
