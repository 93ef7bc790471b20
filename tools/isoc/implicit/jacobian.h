/* The matrix of an implicit method: 1 - hb J for the Jacobian J of x' = f(x), by symbolic differentiation, factored
 * without a pivot search. The matrix is J itself, which is full for a chain, unrolled for its zeros; or for long trees a
 * sparse one with more unknowns (tools/isoc/implicit/extended.h), unrolled as well, or eliminated by loops over constant
 * tables (core/methods/sparse.h) where the code would be too large.
 *
 * The full one is either of the solved equations z' = f, or of those before (tools/isoc/dynamics/balance.h): W z' =
 * left(z') where only what does not depend on z' is differentiated, so that W (d - r) = hb (d left / dx) d. The cheaper
 * is kept, if both are exact.
 */
#ifndef ISOC_IMPLICIT_JACOBIAN_H
#define ISOC_IMPLICIT_JACOBIAN_H

#include "tools/isoc/implicit/extended.h"

/* How factor() and solve() are written. */
typedef enum factoring {
    FACTORING_FULL,   /* J as a full matrix, unrolled for its zeros */
    FACTORING_SPARSE, /* with more unknowns (tools/isoc/implicit/extended.h), unrolled */
    FACTORING_LOOPED, /* the same by loops over constant tables */
    FACTORINGS
} factoring;

extern const char *const factoring_names[FACTORINGS];

typedef struct jacobian {
    factoring kind;
    node *factors; /* what factor() leaves in lu[] for solve(); looped, the matrix that it factorises there */
    int factor_count;
    node *solution;         /* d[], from the right side and the factors; looped, NULL */
    const extended *looped; /* NULL: unrolled */
} jacobian;

/* In the way that is wanted, or that which suits the size for FACTORINGS. That of closed loops is full. */
jacobian jacobian_build(graph *g, const dynamics *d, const node *derivatives, factoring wanted);

#endif
