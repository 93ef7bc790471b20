/* The plant on the rungs of a ladder that drop effects. */
#ifndef ISOC_PLANT_REDUCED_PLANT_H
#define ISOC_PLANT_REDUCED_PLANT_H

#include "tools/isoc/plant/plant.h"
#include "tools/isoc/scene/scene.h"

/* Builds p->reduced_plants: for each drop of the ladder the plant of the scene without the effects that are dropped so far, as if
 * they were left out, but with their states, inputs, memories and tunables in their places. */
void reduced_plants_build(source *s, const scene *written, plant *p, build_options wanted);

/* The plant on a rung, counted from 0; NULL where nothing is dropped. The recipe of its step, and what
 * that is called behind `step`: _heun_without_rub. */
const reduced_plant *reduced_plant_on_rung(const plant *p, int rung);
unsigned rung_recipe(const plant *p, int rung);
const char *rung_suffix(const plant *p, int rung, arena *memory);

#endif
