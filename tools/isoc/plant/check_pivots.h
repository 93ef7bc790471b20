/* The mass matrix at the start. */
#ifndef ISOC_PLANT_CHECK_PIVOTS_H
#define ISOC_PLANT_CHECK_PIVOTS_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/source.h"

/* Notes the joint whose motion moves no inertia: the mass matrix is then singular, and there is no acceleration. */
void pivots_check(source *s, const graph *g, const plant *p);

#endif
