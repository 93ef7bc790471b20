/* One step of a kernel by itself, as iso_method_step makes it. */
#ifndef ISO_TESTS_ONE_STEP_H
#define ISO_TESTS_ONE_STEP_H

#include "core/methods/explicit.h"

/* Of any tableau; for the local error of the step before, where steps are checked. */
ISO_INLINE real one_explicit_step(const iso_tableau *const tableau, const iso_history *const history,
                                  iso_derivative *const f, const real h, const real *const u, const real *const p,
                                  real *const work)
{
    const iso_equations equations = {.derivative = f};
    iso_step step = {.history = history, .equations = &equations, .f = f, .h = h, .u = u, .p = p, .work = work};
    iso_step_begin(&step);
    iso_explicit_step(tableau, &step);
    return step.error;
}

#endif
