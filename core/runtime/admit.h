/* What comes into a plant from outside, inputs and tunables, and what it hands out: never a number that is not finite. The
 * plant keeps the last good ones. Nothing here branches on a number. On the Cortex-M4F the first input or tunable costs 24
 * instructions a tick, with limits 48, an output 15; a plant without inputs and tunables has none of their code. */
#ifndef ISO_CORE_RUNTIME_ADMIT_H
#define ISO_CORE_RUNTIME_ADMIT_H

#include "core/numbers/real.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The range of a quantity; -ISO_REAL_MAX and ISO_REAL_MAX: no limit. */
typedef struct iso_limits {
    real least, most;
} iso_limits;

/* Of all that came in: how often a number was not finite, and the last good one stayed; and how often one was beyond its
 * limits, and was set to the nearer. */
typedef struct iso_refusals {
    uint64_t held;
    uint64_t clamped;
} iso_refusals;

/* Puts v[n] right, and keeps it in good[n]; limits[n], or NULL where none has any. */
static inline void iso_admit(real *const v, real *const good, const iso_limits *const limits, const uint16_t n,
                             iso_refusals *const counted)
{
    uint32_t held = 0, clamped = 0;
    for (uint16_t i = 0; i < n; i++) {
        const iso_bits bad = iso_beyond(v[i], ISO_REAL_MAX);
        real x = iso_select(bad, good[i], v[i]);
        held += (uint32_t)bad & 1;
        if (limits != NULL) {
            const real within = iso_clamp(x, limits[i].least, limits[i].most);
            const iso_bits off = iso_bits_of(x - within) & ~ISO_SIGN_BIT;
            clamped += (uint32_t)(((iso_bits)0 - off) >> ISO_SIGN_SHIFT);
            x = within;
        }
        v[i] = good[i] = x;
    }
    counted->held += held;
    counted->clamped += clamped;
}

/* If one of y[n] is not finite, all are those in good[n], else they are kept there. Returns 1 if one was not, else 0. */
static inline uint32_t iso_hold(real *const y, real *const good, const uint16_t n)
{
    iso_bits bad = 0;
    for (uint16_t i = 0; i < n; i++) {
        bad |= iso_beyond(y[i], ISO_REAL_MAX);
    }
    for (uint16_t i = 0; i < n; i++) {
        y[i] = good[i] = iso_select(bad, good[i], y[i]);
    }
    return (uint32_t)bad & 1;
}

#ifdef __cplusplus
}
#endif

#endif
