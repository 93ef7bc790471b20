/* Heun's method: the trapezoidal rule with an Euler predictor. */
#ifndef ISO_CORE_METHODS_HEUN_H
#define ISO_CORE_METHODS_HEUN_H

#include "core/methods/explicit.h"

/* Heun (1900), Z. Math. Phys. 45, 23-38. */
static const iso_tableau iso_tableau_heun = {
    .stages = 2,
    .order = 2,
    .a = {{0}, {1}},
    .a_over = {1, 1},
    .b = {1, 1},
    .b_over = 2,
};

ISO_INLINE void iso_heun_step(iso_step *const step)
{
    iso_explicit_step_by(&iso_tableau_heun, step, step->sines != NULL);
}

#endif
