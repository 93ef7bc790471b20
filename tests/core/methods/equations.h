/* Equations whose steps are exact in binary. */
#ifndef ISO_TESTS_UNIT_EQUATIONS_H
#define ISO_TESTS_UNIT_EQUATIONS_H

#include "core/numbers/real.h"

/* t' = 1, q' = t^3: rk4 integrates it without error. */
static inline void cubic(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = R(1.0);
    dx[1] = x[0] * x[0] * x[0];
}

/* q' = v, v' = -q. */
static inline void oscillator(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)u;
    (void)p;
    dx[0] = x[1];
    dx[1] = -x[0];
}

/* q' = u p. */
static inline void driven(real *restrict dx, const real *restrict x, const real *restrict u, const real *restrict p)
{
    (void)x;
    dx[0] = u[0] * p[0];
}

#endif
