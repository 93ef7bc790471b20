/* The watch over the pivots of closed loops. With the closures' Jacobian J and the mass matrix M, a step solves with A
 * = J M^-1 J' = L D L'. Near a position where the closures lose rank a pivot D falls to nearly nothing and rises again,
 * as the square of the way to that position, and the forces of the closures turn within that way. A step that is not
 * short against it misses this turn: after it the closures and their rates hold, but the energy has changed. So the
 * product of each closure's pivots is compared with that of the step before: its unit and its usual size do not
 * matter. */
#ifndef ISO_CORE_METHODS_PIVOTS_H
#define ISO_CORE_METHODS_PIVOTS_H

#include "core/methods/progress.h"
#include "core/numbers/real.h"
#include "core/numbers/unroll.h"

/* A step in which no product changes by this factor resolves the passing: tests/isoc/closure/singular. */
#define ISO_PIVOT_CHANGE R(1.25)

/* The products of pivots now[count] behind a step, compared with last[count] before it, which they replace;
 * closures[k] is the closure of product k. Where one has changed by more than ISO_PIVOT_CHANGE, or is not positive,
 * `nearness` says so. Returns all ones then, else 0. No branch on them. */
ISO_INLINE iso_bits iso_watch_pivots(real *const last, const real *const now, const uint16_t *const closures,
                                     const size_t count, iso_nearness *const nearness)
{
    iso_count near = nearness->closure;
    iso_bits any = ISO_NOTHING;
    ISO_UNROLL
    for (size_t k = 0; k < count; k++) {
        const iso_bits apart =
            iso_bits_of(ISO_PIVOT_CHANGE * last[k] - now[k]) | iso_bits_of(ISO_PIVOT_CHANGE * now[k] - last[k]);
        const iso_bits found = iso_mask_of_sign(apart);
        const iso_count changed = (iso_count)found & nearness->known;
        last[k] = now[k];
        near = (changed & (closures[k] + 1U)) | (~changed & near);
        any |= found;
    }
    const iso_bits known = iso_mask_of_lowest(nearness->known);
    nearness->closure = near;
    nearness->known = (iso_count)iso_mask_where(true);
    return any & known;
}

#endif
