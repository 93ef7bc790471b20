/* The checks of a plant: that it is useful at its start. */
#ifndef ISOC_PLANT_CHECKS_H
#define ISOC_PLANT_CHECKS_H

#include "tools/isoc/plant/plant.h"

/* check_start.c: notes the joint whose motion moves no inertia, so that the mass matrix is singular and there is no
 * acceleration; and why the derivative at the start is not finite in the plant's own real: a closure that is lost by
 * rounding, or a joint whose derivative overflows. */
void pivots_check(source *s, const graph *g, const plant *p);
void start_check(source *s, const graph *g, const plant *p);

/* check_range.c: notes a constant of the equations that the plant's type cannot hold: a product of numbers that it can,
 * such as a mass and a square of a length. */
void range_check(source *s, const graph *g, const plant *p);

/* input_check.c: warns where held inputs lower the order of a method, as one with a history takes its inputs for
 * samples of a smooth curve: of the first input that is held there, or whose extrapolation the local error does not
 * see; and of the first function of time in a formula that the derivative depends on, by itself or through memories:
 * noise, say. */
void samples_check(const source *s, const graph *g, const scene *written, const plant *p);

#endif
