/* Vectors of three long doubles, and what is read from jets. */
#ifndef ISO_TESTS_DYNAMICS_WIDE3_H
#define ISO_TESTS_DYNAMICS_WIDE3_H

#include "tests/isoc/dynamics/jet.h"

static inline wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const wide a[3], const wide b[3], wide out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* a += k b. */
static inline void accumulate(wide a[3], const wide k, const wide b[3])
{
    for (int i = 0; i < 3; i++) {
        a[i] += k * b[i];
    }
}

static inline void difference(const wide a[3], const wide b[3], wide out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[i] - b[i];
    }
}

static inline void unit(const wide a[3], wide out[3])
{
    const wide length = sqrtl(dot(a, a));
    for (int i = 0; i < 3; i++) {
        out[i] = a[i] / length;
    }
}

/* c[order] of each component. */
static inline void part(const jet3 a, const int order, wide out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a.x[i].c[order];
    }
}

/* The axis of the frame that has the largest angle with e, and the two unit vectors square to e. */
static inline void across(const wide e[3], wide first[3], wide second[3])
{
    wide u[3] = {0.0L, 0.0L, 0.0L};
    int least = 0;
    for (int i = 1; i < 3; i++) {
        least = fabsl(e[i]) < fabsl(e[least]) ? i : least;
    }
    u[least] = 1.0L;
    wide v[3];
    cross(e, u, v);
    unit(v, first);
    cross(e, first, v);
    unit(v, second);
}

#endif
