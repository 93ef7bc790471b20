/* Linear equations in long double, some of which may follow from others. */
#ifndef ISO_TESTS_DYNAMICS_LINEAR_H
#define ISO_TESTS_DYNAMICS_LINEAR_H

#include <stdbool.h>

#include "tests/isoc/dynamics/jet.h"

enum { UNKNOWNS_MAX = 160 };

typedef struct linear_system {
    int n;
    wide a[UNKNOWNS_MAX][UNKNOWNS_MAX + 1]; /* the last column, [n], is the right-hand side */
} linear_system;

/* Gauss's elimination with complete pivoting. Where the pivots, which are of size 1 after scaling, fall below `least`,
 * what is left follows from the other equations: it is left out, and as many of the n unknowns x are zero. False if
 * what is left contradicts. Overwrites the system. */
bool linear_solve(linear_system *s, wide least, wide *x);

#endif
