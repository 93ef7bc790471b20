/* Causes of stiffness: the effects, the damping and the springs of its joints, springs between points, and the
 * stabilisation of its closures; and the mechanism without one of them. */
#ifndef ISOC_STABILITY_CAUSES_H
#define ISOC_STABILITY_CAUSES_H

#include "tools/isoc/mechanism/mechanism.h"

typedef struct cause {
    const char *sort, *name; /* effect 'drive' */
    place at;
} cause;

int cause_count(const mechanism *m);

cause cause_of(const mechanism *m, int which);

/* A mechanism of its own that lacks it: the states of an effect stay, and rest. */
mechanism without_cause(const mechanism *m, graph *g, int which);

#endif
