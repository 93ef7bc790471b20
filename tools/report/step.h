/* Read before a plant (cc -include): its methods then take their step from a variable, adams its tolerance, so that one
 * program runs with any. The numbers are the same; the instructions are not, since nothing of them folds. */
#ifndef ISO_REPORT_STEP_H
#define ISO_REPORT_STEP_H

#include "core/methods/method.h"

#define report_step ISO_REAL_NAME(report_step)
extern real report_step;

#define report_tolerance ISO_REAL_NAME(report_tolerance)
extern real report_tolerance;

/* The options of a plant, but for the tolerance. */
static inline iso_adams_options report_options(iso_adams_options options)
{
    options.tolerance_absolute = report_tolerance;
    options.tolerance_relative = report_tolerance;
    return options;
}

#define iso_method_step(recipe, n, eq, h, ...) iso_method_step(recipe, n, eq, report_step, __VA_ARGS__)
#define iso_method_prime(recipe, n, eq, h, ...) iso_method_prime(recipe, n, eq, report_step, __VA_ARGS__)
#define iso_adams_tick(options, ...) iso_adams_tick((iso_adams_options[]){report_options(*(options))}, __VA_ARGS__)
#define iso_adams_start(options, ...) iso_adams_start((iso_adams_options[]){report_options(*(options))}, __VA_ARGS__)

#endif
