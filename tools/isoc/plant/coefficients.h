/* Products with what follows from tunables alone, as with constants: it gathers in front, so that it is one number, which is
 * computed when a tunable changes. */
#ifndef ISOC_PLANT_COEFFICIENTS_H
#define ISOC_PLANT_COEFFICIENTS_H

#include "tools/isoc/graph/graph.h"

/* In all that the roots are made of, c (p x) becomes (c p) x, (p x) (q y) becomes (p q) (x y), and x / p becomes (1 / p) x, for
 * p and q of tunables. */
void gather_coefficients(graph *g, node *roots, size_t count);

#endif
