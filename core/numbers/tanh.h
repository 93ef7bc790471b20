/* The hyperbolic tangent without a branch, in + - * / sqrt and bits.
 *
 * Domain: all numbers; error at most 4 ulp (tests/core/numbers/exhaustive/tanh.c), within [-1, 1], tanh(-x) = -tanh(x)
 * exactly, tanh(0) = 0. A result is at most 2 ulp below that of a smaller x. An infinity gives 1 with its sign, and so
 * does a NaN.
 *
 * tanh = y / sqrt(1 + y^2) of y = sinh x, as x + x^3 q(x^2). A relative error of y is divided by 1 + y^2 in the result,
 * so q has few terms: it is minimax with that weight, by Lawson's iteration (Lawson 1961; Muller 2016, Elementary
 * Functions, ch. 3). All its terms are positive, so y grows beyond every bound, and the result is 1: sqrt(y^2) is y.
 */
#ifndef ISO_CORE_NUMBERS_TANH_H
#define ISO_CORE_NUMBERS_TANH_H

#include "core/numbers/sqrt.h"

#ifdef ISO_REAL_DOUBLE

/* (sinh(x) - x) / x^3 of z = x^2 */
static inline real iso_sinh_tail(const real z)
{
    real q = R(1.81658345520025876e-28);
    q = q * z + R(4.20866545438487279e-26);
    q = q * z + R(4.15160242596395266e-23);
    q = q * z + R(1.93641975866179782e-20);
    q = q * z + R(8.23008217653946408e-18);
    q = q * z + R(2.81118904586237565e-15);
    q = q * z + R(7.64721149793513075e-13);
    q = q * z + R(1.60590385902364009e-10);
    q = q * z + R(2.50521087287582027e-08);
    q = q * z + R(2.75573192113544247e-06);
    q = q * z + R(1.98412698415074821e-04);
    q = q * z + R(8.33333333333140247e-03);
    return q * z + R(1.66666666666667129e-01);
}

#else

static inline real iso_sinh_tail(const real z)
{
    real q = R(3.388401382e-8);
    q = q * z + R(2.623659611e-6);
    q = q * z + R(1.991183672e-4);
    q = q * z + R(8.332042024e-3);
    return q * z + R(1.666672528e-1);
}

#endif

static inline real iso_tanh(const real x)
{
    /* From 9.02 on, in double 19.1, the result is 1; the square of y must not overflow. */
    const real limited = iso_limited(x, R(32.0));
    const real z = limited * limited;
    const real y = limited + limited * (z * iso_sinh_tail(z));
    return y / iso_sqrt(R(1.0) + y * y);
}

#endif
