/* Inputs and tunables that come into a plant: never a number that is not finite. The plant keeps the last good
 * ones. Nothing here branches on a number. Most ticks have nothing to correct: iso_plant_admit checks that first, by
 * its one branch. On the Cortex-M4F an input then costs 7 instructions a tick, with limits 12, and a tunable 4; a tick
 * with a correction, or with another value of a tunable, some 15 more for each, with limits some 40. A plant without
 * inputs and tunables has none of it. */
#ifndef ISO_CORE_RUNTIME_ADMIT_H
#define ISO_CORE_RUNTIME_ADMIT_H

#include "core/numbers/real.h"
#include "core/numbers/unroll.h"

/* The range of a quantity; -ISO_REAL_MAX and ISO_REAL_MAX: no limit. */
typedef struct iso_limits {
    iso_scalar least, most;
} iso_limits;

/* Counts over all inputs and tunables. held: a number was not finite, and the last good one stayed, or tunables broke a
 * condition of the scene, and all stayed. clamped: a number was beyond its limits, and was set to the nearer one. */
typedef struct iso_refusals {
    uint64_t held;
    uint64_t clamped;
} iso_refusals;

/* Refusals of a tick: inputs, then parameters, of each the number held and in the upper 16 bits the number clamped. No
 * branch depends on them: 0 is the rule, and iso_count_refused counts the others. */
typedef iso_pair iso_refused;

/* Corrects v[n], and copies it to good[n]. limits[n] is NULL if no number has limits. Adds the changed bits to
 * *changed, if not NULL. Returns the number of values held, and in the upper 16 bits the number of values clamped. */
static inline iso_count iso_admit(real *const v, real *const good, const iso_limits *const limits, const uint16_t n,
                                  iso_bits *const changed)
{
    iso_count refused = ISO_NOTHING;
    for (uint16_t i = 0; i < n; i++) {
        const iso_bits bad = iso_not_finite(v[i]);
        real x = iso_select(bad, good[i], v[i]);
        refused += (iso_count)bad & 1;
        if (limits != NULL) {
            const real within = iso_clamp(x, iso_all(limits[i].least), iso_all(limits[i].most));
            const iso_bits off = iso_bits_of(x - within) & ~ISO_SIGN_BIT;
            refused += (iso_count)((0 - off) >> ISO_SIGN_SHIFT) << 16;
            x = within;
        }
        if (changed != NULL) {
            *changed |= iso_bits_of(x) ^ iso_bits_of(good[i]);
        }
        v[i] = good[i] = x;
    }
    return refused;
}

/* Where `broken` is all ones, sets v[n] and good[n] to before[n], and returns 1; else returns 0. */
static inline iso_count iso_put_back(real *const v, real *const good, const real *const before, const uint16_t n,
                                     const iso_bits broken)
{
    for (uint16_t i = 0; i < n; i++) {
        v[i] = good[i] = iso_select(broken, before[i], v[i]);
    }
    return (iso_count)broken & 1;
}

/* 0 if each of v[n] is finite and within its limits, so that iso_admit would change none. -0 where the limit is 0 may
 * count as beyond. In the order of iso_order a NaN or an infinity is beyond all limits. */
ISO_INLINE iso_bits iso_any_amiss(const real *const v, const iso_limits *const limits, const uint32_t n)
{
    iso_bits amiss = ISO_NOTHING;
    ISO_UNROLL_LONG
    for (uint32_t i = 0; i < n; i++) {
        if (limits == NULL) {
            amiss |= iso_not_finite(v[i]);
        } else {
            const iso_bits least = iso_order(iso_all(limits[i].least));
            amiss |= (iso_bits)(iso_order(iso_all(limits[i].most)) - least < iso_order(v[i]) - least);
        }
    }
    return amiss;
}

/* Not 0 if one of n numbers has changed. */
ISO_INLINE iso_bits iso_any_changed(const real *const latest, const real *const before, const uint32_t n)
{
    iso_bits changed = ISO_NOTHING;
    ISO_UNROLL_LONG
    for (uint32_t i = 0; i < n; i++) {
        changed |= iso_bits_of(latest[i]) ^ iso_bits_of(before[i]);
    }
    return changed;
}

/* Adds the result of iso_admit to the counts, of inputs or of parameters. */
static inline void iso_count_refused(iso_refusals *const counted, const uint32_t refused)
{
    counted->held += refused & 0xFFFF;
    counted->clamped += refused >> 16;
}

#endif
