/* The elimination of a sparse matrix before its numbers are known: its order, where it fills in, and the tables that a
 * plant has of it (core/methods/sparse.h). */
#ifndef ISOC_IMPLICIT_ELIMINATION_H
#define ISOC_IMPLICIT_ELIMINATION_H

#include <stdbool.h>
#include <stdint.h>

#include "tools/isoc/base/arena.h"

/* Places of a square matrix that may be other than zero. */
typedef struct pattern {
    arena *memory;
    int count;
    size_t words;   /* of a row */
    uint64_t *rows; /* [count words] a bit for each column */
} pattern;

typedef struct elimination {
    int count;    /* of unknowns */
    int places;   /* of the factors, */
    int lower;    /* and of them before the diagonal */
    int *order;   /* [count] the unknowns as they are eliminated */
    int *turn;    /* [count] when an unknown is eliminated */
    int *row;     /* [count + 1] where the rows begin, in the order of the elimination */
    int *beyond;  /* [count] where what is right of the diagonal begins */
    int *column;  /* [places] the columns, in the order of the elimination */
    int products; /* of a factorisation, without those by the inverse of the diagonal */
    int *target;  /* [products] where in its row each goes */
} elimination;

pattern pattern_start(arena *memory, int count);
void pattern_add(pattern *p, int row, int column);

/* The order goes through the groups from the last to the first; in a group it takes the unknown first that makes the
 * least fill-in. The pattern is used up. */
elimination elimination_of(pattern *p, const int *groups);

/* Where an entry stands; both are numbers of unknowns. */
int elimination_place(const elimination *e, int row, int column);

#endif
