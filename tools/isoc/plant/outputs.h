/* The nodes of the outputs, with their names and units. */
#ifndef ISOC_PLANT_OUTPUTS_H
#define ISOC_PLANT_OUTPUTS_H

#include "tools/isoc/plant/plant.h"

/* Fills p->outputs, p->output_names and p->output_units from p->m and p->d. */
void outputs_build(plant *p, graph *g);

#endif
