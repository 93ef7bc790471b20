/* The checks of a plant: that it is useful at its start. */
#ifndef ISOC_PLANT_CHECKS_H
#define ISOC_PLANT_CHECKS_H

#include "tools/isoc/plant/plant.h"

/* check_pivots.c: the mass matrix at the start. */

/* Notes the joint whose motion moves no inertia: the mass matrix is then singular, and there is no acceleration. */
void pivots_check(source *s, const graph *g, const plant *p);

/* check_range.c: the constants of a plant's equations. */

/* Notes a constant that the plant's type cannot hold: a product of numbers that it can, such as a mass and a square of
 * a length. */
void range_check(source *s, const graph *g, const plant *p);

/* check_start.c: the equations at the start, as the plant computes them. */

/* Notes why the derivative at the start is not finite in the plant's own real: a closure that is lost by rounding, or a
 * joint whose derivative overflows. */
void start_check(source *s, const graph *g, const plant *p);

/* input_check.c: warns where held inputs lower the order of a method: a method with a history takes what it is given
 * for samples of a smooth curve. */

/* Warns of the first input that is held where the method has a history, or whose extrapolation the local error does not see;
 * and of the first function of time in a formula that the derivative depends on, by itself or through memories: noise, say. */
void samples_check(const source *s, const graph *g, const scene *written, const plant *p);

#endif
