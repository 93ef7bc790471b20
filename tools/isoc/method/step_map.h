/* The map of a step of a method on x' = J x: a matrix, since every kernel is linear there. It is that of the kernel
 * itself, which tools have in double: a step from each unit vector. */
#ifndef ISOC_METHOD_STEP_MAP_H
#define ISOC_METHOD_STEP_MAP_H

#include <stdbool.h>

#include "tools/isoc/base/arena.h"

typedef struct linear_plant {
    const double *jacobian; /* [n n] row by row */
    int n, positions;       /* the first rows are of positions, the others of speeds */
} linear_plant;

/* The map of the states and the recipe's history over a step: [*size *size] row by row, the states first. For adams it
 * is one sub-step, at its highest order. */
double *step_map(arena *memory, unsigned recipe, const linear_plant *l, double step, int *size);

/* b of the 1 - h b J that a step of the kernel solves with; 0 where it solves nothing. */
double implicit_part(arena *memory, unsigned recipe);

/* The map of a step of two rates (core/methods/multirate.h) with the fast ones of the states: [n n]; for the methods
 * that it has. */
double *two_rates_map(arena *memory, unsigned recipe, const linear_plant *l, const bool *is_fast, int substeps,
                      double step);

#endif
