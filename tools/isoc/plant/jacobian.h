/* What an implicit method solves with: 1 - hb J for the Jacobian J of x' = f(x), by symbolic differentiation, factored
 * without a pivot search and unrolled for its zeros.
 *
 * Either of the solved equations z' = f, or of those before (tools/isoc/dynamics/balance.h): W z' = left(z') where only
 * what does not depend on z' is differentiated, so that W (d - r) = hb (d left / dx) d. The cheaper is kept, if
 * both are exact.
 */
#ifndef ISOC_PLANT_JACOBIAN_H
#define ISOC_PLANT_JACOBIAN_H

#include "tools/isoc/dynamics/dynamics.h"

typedef struct jacobian {
    node *factors; /* what factor() leaves in lu[] for solve() */
    int factor_count;
    node *solution; /* d[], from the right side and the factors */
} jacobian;

jacobian jacobian_build(graph *g, const dynamics *d, const node *derivatives);

#endif
