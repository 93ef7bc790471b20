/* Start values that satisfy the closures, computed at compile time. */
#ifndef ISOC_DYNAMICS_ASSEMBLY_H
#define ISOC_DYNAMICS_ASSEMBLY_H

#include "tools/isoc/dynamics/dynamics.h"

/* Newton's method moves the coordinates and speeds with no start, or a rough one, until the closures hold. Given starts
 * are kept, up to the rounding of their digits. Changes the segments' start and speed; the graph stays as it is. Notes a
 * problem with residual and rank if the closures cannot hold, if coordinates stay undetermined, or if constraints are
 * redundant and the stabilisation does not allow that. */
void assemble(source *s, const graph *g, const mechanism *m);

#endif
