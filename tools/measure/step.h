/* Read before a plant (cc -include): its methods then take their step from a variable, adams its tolerance, so that one
 * program runs with any. The numbers are the same; the instructions are not, since nothing of them folds. */
#ifndef ISO_REPORT_STEP_H
#define ISO_REPORT_STEP_H

#ifndef ISO_METHOD_LIST
#include "core/methods/all.h"
#endif
#include "core/methods/adams.h"
#include "core/methods/primed.h"

#define report_step ISO_REAL_NAME(report_step)
extern real report_step;

#define report_tolerance ISO_REAL_NAME(report_tolerance)
extern real report_tolerance;

/* The equations of a plant, with the options of adams but for the tolerance. */
static inline iso_equations report_equations(iso_equations equations)
{
    static iso_adams_options options;
    options = equations.adams == NULL ? iso_adams_default : *equations.adams;
    options.tolerance_absolute = report_tolerance;
    options.tolerance_relative = report_tolerance;
    equations.adams = &options;
    return equations;
}

#define REPORT_EQUATIONS(eq) ((iso_equations[]){report_equations(*(eq))})

#define iso_method_step(recipe, n, eq, h, ...)                                                                         \
    iso_method_step(recipe, n, REPORT_EQUATIONS(eq), report_step, __VA_ARGS__)
#define iso_method_prime(recipe, n, eq, h, ...)                                                                        \
    iso_method_prime(recipe, n, REPORT_EQUATIONS(eq), report_step, __VA_ARGS__)

#endif
