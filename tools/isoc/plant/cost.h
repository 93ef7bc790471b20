/* The cost of a step: operations of the equations, of the method, and of what follows it. */
#ifndef ISOC_PLANT_COST_H
#define ISOC_PLANT_COST_H

#include "tools/isoc/plant/plant.h"

/* Of a step, but for what follows the method in it (tools/isoc/dynamics/settled.h); and of that. */
operations cost_of_step(const plant *p, const graph *g);
operations cost_of_settling(const plant *p, const graph *g);

/* The cost of solving with 1 - hb J, of an implicit method. */
typedef struct implicit_cost {
    operations factor, solve;
} implicit_cost;

implicit_cost cost_of_solving(const plant *p, const graph *g);

#endif
