/* The resistance to a push within a step, as nodes: the mass matrix; with an implicit method, what the method solves with,
 *
 *     M - h b dQ/dq' - (h b)^2 dQ/dq,
 *
 * with the efforts Q of dampers, springs and effects, of which the symmetric part is taken.
 */
#ifndef ISOC_DYNAMICS_RESISTANCE_H
#define ISOC_DYNAMICS_RESISTANCE_H

#include "tools/isoc/dynamics/dynamics.h"

/* Factorised; d->mass itself where nothing is added to it. */
const mass_matrix *resistance_build(graph *g, const dynamics *d);

#endif
