/* Euler's method: x += h f. */
#ifndef ISO_CORE_METHODS_EULER_H
#define ISO_CORE_METHODS_EULER_H

#include "core/methods/explicit.h"

/* Euler (1768), Institutionum calculi integralis, vol. 1, sec. 2, ch. 7. */
static const iso_tableau iso_tableau_euler = {
    .stages = 1,
    .order = 1,
    .a_over = {1},
    .b = {1},
    .b_over = 1,
};

ISO_INLINE void iso_euler_step(iso_step *const step)
{
    iso_explicit_step(&iso_tableau_euler, step);
}

#endif
