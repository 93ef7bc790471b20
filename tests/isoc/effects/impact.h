/* Impacts with the law F = -k x (1 + d x'), whatever k is. After one with the speed v the speed w is that of
 * d (v + w) = ln((1 + d v) / (1 - d w)): Marhefka, Orin (1999), IEEE Trans. SMC A 29(6), eq. 24. */
#ifndef ISO_TESTS_EFFECTS_IMPACT_H
#define ISO_TESTS_EFFECTS_IMPACT_H

#include <math.h>

/* The speed after an impact with v, by bisection: the left side is the larger one below it. */
static inline double speed_after(const double v, const double d)
{
    double low = 0.0, high = v;
    for (int i = 0; i < 60; i++) {
        const double w = 0.5 * (low + high);
        *(d * (v + w) < log((1.0 + d * v) / (1.0 - d * w)) ? &high : &low) = w;
    }
    return low;
}

/* The d that leaves `rest`, between 0 and 1, of a speed of 1. */
static inline double damping_of(const double rest)
{
    double low = 0.0, high = 1.0 / rest;
    for (int i = 0; i < 60; i++) {
        const double d = 0.5 * (low + high);
        *(speed_after(1.0, d) > rest ? &low : &high) = d;
    }
    return low;
}

#endif
