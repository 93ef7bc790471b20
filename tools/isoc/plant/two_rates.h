/* What a step of two rates does to x' = J x. */
#ifndef ISOC_PLANT_TWO_RATES_H
#define ISOC_PLANT_TWO_RATES_H

#include <stdbool.h>

#include "tools/isoc/base/arena.h"

/* The matrix [n n] of a step of core/methods/multirate.h, row by row, with the fast ones of x; the methods that it has. */
double *two_rates_map(arena *memory, const double *j, int n, const bool *is_fast, int substeps, unsigned recipe,
                      double step);

#endif
