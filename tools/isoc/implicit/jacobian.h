/* The matrix of an implicit method: 1 - hb J for the Jacobian J of x' = f(x), by symbolic differentiation, factored
 * without a pivot search. The matrix is J itself, which is full for a chain, unrolled for its zeros; or for long trees
 * a sparse one with more unknowns (tools/isoc/implicit/jacobian.h), unrolled as well, or eliminated by loops over
 * constant tables (core/methods/sparse.h) where the code would be too large.
 *
 * The full one is either of the solved equations z' = f, or of those before (tools/isoc/dynamics/dynamics.h): W z' =
 * left(z') where only the part independent of z' is differentiated, so that W (d - r) = hb (d left / dx) d. The cheaper
 * is kept, if both are exact.
 */
#ifndef ISOC_IMPLICIT_JACOBIAN_H
#define ISOC_IMPLICIT_JACOBIAN_H

#include <stdint.h>

#include "tools/isoc/dynamics/dynamics.h"

/* elimination.c: the elimination of a sparse matrix before its numbers are known: its order, where it fills in, and
 * the tables that a plant has of it (core/methods/sparse.h). */

/* Places of a square matrix that may be other than zero. */
typedef struct pattern {
    arena *memory;
    int count;
    size_t words;   /* of a row */
    uint64_t *rows; /* [count words] a bit for each column */
} pattern;

typedef struct elimination {
    int count;    /* of unknowns */
    int nonzeros; /* of the factors */
    int lower;    /* nonzeros before the diagonal */
    int *order;   /* [count] the unknowns as they are eliminated */
    int *place;   /* [count] of an unknown in that order */
    int *row;     /* [count + 1] where the rows begin, in the order of the elimination */
    int *beyond;  /* [count] the begin of the entries right of the diagonal */
    int *column;  /* [nonzeros] the columns, in the order of the elimination */
    int products; /* of a factorisation, without those by the inverse of the diagonal */
    int *target;  /* [products] where in its row each goes */
} elimination;

pattern pattern_start(arena *memory, int count);
void pattern_add(pattern *p, int row, int column);

/* The order goes through the groups from the last to the first; in a group it takes the unknown first that makes the
 * least fill-in. The pattern is used up. */
elimination elimination_of(pattern *p, const int *groups);

/* Where an entry stands; both are numbers of unknowns. */
int elimination_index(const elimination *e, int row, int column);

/* extended.c: 1 - hb J of a tree as a sparse matrix: its unknowns are, beside the changes of the states, those of all
 * quantities that recursive Newton-Euler hands from segment to segment. Each row then has entries of one segment and
 * its neighbours, so that the number of entries, and of products of their factorisation, grows in proportion to the
 * length of a chain; J itself is full. */

typedef struct extended {
    elimination e;
    node *entries;  /* [e.nonzeros] zero where it fills in */
    int *right_row; /* [states] the row that has the right side of a state, in the order of the elimination */
    int *found;     /* [states] the unknown that the state is, likewise */
} extended;

const extended *extended_build(graph *g, const dynamics *d, const node *derivatives);

/* The forms of factor() and solve(). */
typedef enum factoring {
    FACTORING_FULL,   /* J as a full matrix, unrolled for its zeros */
    FACTORING_SPARSE, /* with more unknowns (tools/isoc/implicit/jacobian.h), unrolled */
    FACTORING_LOOPED, /* the same by loops over constant tables */
    FACTORINGS
} factoring;

extern const char *const factoring_names[FACTORINGS];

typedef struct jacobian {
    factoring kind;
    node *
        factors; /* the factors that factor() leaves in lu[] for solve(); looped, the matrix that it factorises there */
    int factor_count;
    node *solution;         /* d[], from the right side and the factors; looped, NULL */
    const extended *looped; /* NULL: unrolled */
} jacobian;

/* In the form that is wanted; for FACTORINGS in the one that suits the size. The matrix of closed loops is full. */
jacobian jacobian_build(graph *g, const dynamics *d, const node *derivatives, factoring wanted);

#endif
