/* The summaries of a plant and of the methods that isoc prints. */
#ifndef ISOC_PLANT_SUMMARY_H
#define ISOC_PLANT_SUMMARY_H

#include "tools/isoc/base/text.h"
#include "tools/isoc/plant/plant.h"

/* Lines `key value...` about one plant. */
void write_summary(const plant *p, const graph *g, text *out);

/* One line for each method: order, evaluations, Jacobians and solutions a step, vectors of n reals kept from step to
 * step, without and with a check. */
void write_methods(text *out);

#endif
