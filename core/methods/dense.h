/* Factors of 1 - hb J for a plant written by hand, whose Jacobian is a full matrix: Gaussian elimination without a
 * pivot search, whose time does not depend on data. It is accurate if the diagonal of 1 - hb J dominates, as it does
 * for steps that resolve the motion, and for the stiff, damped directions of mechanical plants. A generated plant has
 * its own elimination, unrolled for the zeros of its Jacobian, or that of core/methods/sparse.h. */
#ifndef ISO_CORE_METHODS_DENSE_H
#define ISO_CORE_METHODS_DENSE_H

#include <stddef.h>

#include "core/numbers/real.h"

/* Turns a[n n], the Jacobian by rows, into the factors L U of 1 - hb J; L has ones on its diagonal, that of U is kept
 * inverted. Golub and Van Loan (2013), Matrix Computations, algorithm 3.2.1. */
static inline void iso_dense_factor(real *const a, const size_t n, const real hb)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            a[i * n + j] = (i == j ? R(1.0) : R(0.0)) - hb * a[i * n + j];
        }
    }
    for (size_t k = 0; k < n; k++) {
        a[k * n + k] = R(1.0) / a[k * n + k];
        for (size_t i = k + 1; i < n; i++) {
            a[i * n + k] *= a[k * n + k];
            for (size_t j = k + 1; j < n; j++) {
                a[i * n + j] -= a[i * n + k] * a[k * n + j];
            }
        }
    }
}

/* Solves L U d = d in place, d[n]. */
static inline void iso_dense_solve(real *const d, const real *const a, const size_t n)
{
    for (size_t i = 1; i < n; i++) {
        for (size_t j = 0; j < i; j++) {
            d[i] -= a[i * n + j] * d[j];
        }
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t j = i + 1; j < n; j++) {
            d[i] -= a[i * n + j] * d[j];
        }
        d[i] *= a[i * n + i];
    }
}

#endif
