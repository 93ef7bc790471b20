/* The law of impact of Hunt and Crossley, which stops, bumpers, backlash and contacts share. */
#ifndef ISOC_FORMULA_IMPACT_H
#define ISOC_FORMULA_IMPACT_H

#include "tools/isoc/graph/graph.h"

/* The restitutions that have a damping. Without any rest it would be infinite. */
#define LEAST_RESTITUTION 0.01

/* The damping d, for a speed of impact of 1, with which the force k x (1 + d x') at the depth x leaves the part e of the
 * speed, from LEAST_RESTITUTION to 1. Of constants within 1e-13; of tunables in float within 1e-5 of it. */
node impact_damping(graph *g, node e);

#endif
