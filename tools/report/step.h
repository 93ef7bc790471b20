/* Read before a plant (cc -include): its methods then take their step from a variable, so that one program runs with
 * any step. The numbers are the same; the instructions are not, since nothing of the step folds. */
#ifndef ISO_REPORT_STEP_H
#define ISO_REPORT_STEP_H

#include "core/method.h"

#define report_step ISO_REAL_NAME(report_step)
extern real report_step;

#define iso_method_step(recipe, n, eq, h, ...) iso_method_step(recipe, n, eq, report_step, __VA_ARGS__)
#define iso_method_prime(recipe, n, eq, h, ...) iso_method_prime(recipe, n, eq, report_step, __VA_ARGS__)

#endif
