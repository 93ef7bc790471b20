/* Where an effect is steepest. */
#ifndef ISOC_STABILITY_STEEPEST_H
#define ISOC_STABILITY_STEEPEST_H

#include "tools/isoc/stability/slopes.h"

/* The most points that are found for one effect. */
enum { STEEPEST_POINTS = 2 };

/* The states beside a kink of an effect's formulas (of min, max, abs, sign, a comparison; one state is moved there from x), at
 * which its efforts, forces and rates have the largest slope by a position, and by a speed or a state of an effect: those that
 * are steeper than at x itself. u: inputs and memories. Returns how many. */
int steepest_points(const graph *g, const mechanism *m, int effect, const double *x, const double *u,
                    double *points[STEEPEST_POINTS]);

#endif
