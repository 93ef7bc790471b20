/* What a plant costs, counted: operations of its equations and of a step, and what each method keeps. */
#ifndef ISOC_PLANT_COST_H
#define ISOC_PLANT_COST_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/plant/plant.h"

/* Lines `key value...` about one plant. */
void cost_summary(const plant *p, const graph *g, text *out);

/* Of a step, but for what follows the method in it (tools/isoc/dynamics/settled.h). */
operations cost_of_step(const plant *p, const graph *g);

/* One line for each method: order, evaluations, Jacobians and solutions a step, vectors of n reals kept from step to
 * step, without and with a check. */
void cost_methods(text *out);

#endif
