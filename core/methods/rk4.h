/* The classical Runge-Kutta method of order four. */
#ifndef ISO_CORE_METHODS_RK4_H
#define ISO_CORE_METHODS_RK4_H

#include "core/methods/explicit.h"

/* Kutta (1901), Z. Math. Phys. 46, 435-453. */
static const iso_tableau iso_tableau_rk4 = {
    .stages = 4,
    .order = 4,
    .a = {{0}, {1}, {0, 1}, {0, 0, 1}},
    .a_over = {1, 2, 2, 1},
    .b = {1, 2, 2, 1},
    .b_over = 6,
};

ISO_INLINE void iso_rk4_step(iso_step *const step)
{
    iso_explicit_step_by(&iso_tableau_rk4, step, step->sines != NULL);
}

#endif
