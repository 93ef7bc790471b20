/* Newton's method over the coordinates and speeds of closed loops, at compile time. */
#ifndef ISOC_DYNAMICS_CLOSING_H
#define ISOC_DYNAMICS_CLOSING_H

#include "tools/isoc/dynamics/dynamics.h"

typedef struct closing {
    const dynamics *d;
    const mechanism *m;
    const constraints *held;
    arena *memory;
    double *x, *numbers; /* states, and the values of all nodes at them */
    double *jacobian;    /* [constraints][degrees of freedom] */
} closing;

/* What is left open most, by how much, and the rank of the constraints in the free ones. */
typedef struct gap {
    double size;   /* m or rad, or per second */
    int row;       /* which constraint */
    int rank, all; /* of the rates all constraints count, of the positions those that are not of velocities only */
} gap;

/* Whether the constraint counts. */
bool closing_counts(const closing *c, bool rates, int row);

closing closing_start(arena *memory, const dynamics *d);

/* Moves the positions, or the speeds, that are free to where the closures hold, as far as they can. */
gap closing_run(const closing *c, bool rates, const bool *is_free);

/* The same for positions from where they are, and, where that does not lead to less than `enough`, from other places.
 */
gap closing_search(const closing *c, const bool *is_free, double enough);

#endif
