/* The energy of a mechanism held through steps near a singular position of its closures (core/methods/pivots.h). There
 * the forces of the closures turn within less than a step, so that the step of a method is no motion: the positions and
 * the direction of the speeds may belong to another branch, as those of the mechanism itself may after a change of the
 * start by rounding, and the size of the speeds has no bound. The closures do no work, so that the size follows from
 * the energy: the speeds are scaled until the energy is that before the step. With one degree of freedom this
 * determines the motion but for its branch. The work of inputs, losses and effects in such a step is left out. */
#ifndef ISO_CORE_METHODS_HOLD_ENERGY_H
#define ISO_CORE_METHODS_HOLD_ENERGY_H

#include "core/methods/pivots.h"
#include "core/numbers/sqrt.h"

/* After a step with `near` of iso_watch_pivots: scales speeds[count], where this step or the last one was near, so that
 * `total`, the energy of the states, becomes that of before; `rest` is the energy with all speeds zero (J). The speeds
 * then satisfy the closures as before, since these are linear in them. The step after one that was near belongs to it:
 * the middle one of a passing can begin and end with the same pivots. No branch on any of them. */
ISO_INLINE void iso_hold_energy(iso_held_energy *const held, const iso_bits near, const real total, const real rest,
                                real *const speeds, const size_t count)
{
    const iso_bits holds = near | held->near;
    const real kinetic = total - rest;
    const iso_bits moves = iso_less(iso_all(ISO_REAL_LEAST), kinetic);
    const real ratio = iso_positive(held->energy - rest) / iso_select(moves, kinetic, R(1.0));
    const real scale = iso_select(holds & moves, iso_sqrt(ratio), R(1.0));
    ISO_UNROLL
    for (size_t s = 0; s < count; s++) {
        speeds[s] *= scale;
    }
    held->energy = iso_select(holds, held->energy, total);
    held->near = near;
}

#endif
