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

/* The largest gap, its constraint, and the rank of the constraints in the free coordinates. */
typedef struct gap {
    double size;   /* m or rad, or per second */
    int row;       /* which constraint */
    int rank, all; /* for rates all constraints count, for positions those that constrain positions */
} gap;

/* Whether the constraint counts. */
bool closing_counts(const closing *c, bool rates, int row);

closing closing_start(arena *memory, const dynamics *d);

/* Evaluates all nodes and the Jacobian at c->x. */
void closing_evaluate(const closing *c);

/* Moves the positions, or the speeds, by a change of each degree of freedom. */
void closing_move(const closing *c, bool rates, const double *by);

/* The gap of a constraint, or its rate. */
double closing_gap(const closing *c, bool rates, int row);

/* Moves the free positions, or the free speeds, until the closures hold, as far as possible. */
gap closing_run(const closing *c, bool rates, const bool *is_free);

/* The same for positions, from their present values; if the gap stays above `enough`, also from other values. */
gap closing_search(const closing *c, const bool *is_free, double enough);

#endif
