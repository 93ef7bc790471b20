/* Start values that satisfy the closures, computed at compile time. */
#ifndef ISOC_DYNAMICS_ASSEMBLY_H
#define ISOC_DYNAMICS_ASSEMBLY_H

#include "tools/isoc/dynamics/dynamics.h"

/* Newton's method moves the coordinates and speeds with no start, or a rough one, until the closures hold. Given starts
 * are kept, up to the rounding of their digits. Changes the segments' start and speed; the graph stays as it is. Notes
 * a problem with residual and rank if the closures cannot hold, if coordinates stay undetermined, or if constraints are
 * redundant and the stabilisation does not allow that. */
void assemble(source *s, const graph *g, const mechanism *m);

/* closing.c: Newton's method over the coordinates and speeds of closed loops, at compile time. */

typedef struct closing {
    const dynamics *d;
    const mechanism *m;
    const constraints *phi;
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

/* branches.c: where a loop can be assembled in several ways that meet: the constraints lose rank there. At compile
 * time. */

/* Returns how many coordinates are undetermined at the solution c->x: the freedoms of all that is_free. If none is, but
 * the constraints have lost rank, it is a multiple root: two ways to close the loops meet. Such a root was found to the
 * root of the rounding only; it is moved to where the constraints lose rank. `meets` [degrees of freedom] becomes true
 * for those that take part in that. */
int branches_look(const closing *c, const bool *is_free, bool *meets);

/* The rank of the constraints' rates in all coordinates, at a position that is a little farther on. */
int branches_rank_nearby(const closing *c);

#endif
