/* What does not change within a step: what follows from tunables, held inputs and memories alone. It is computed once a
 * step, and stands in an array h for all evaluations of the derivative. */
#ifndef ISOC_PLANT_HELD_H
#define ISOC_PLANT_HELD_H

#include "tools/isoc/graph/graph.h"
#include "tools/isoc/mechanism/mechanism.h"

typedef struct held {
    node *values; /* h: of tunables and inputs */
    int count;    /* 0: nothing is held, as that would not pay */
} held;

/* Puts leaves OP_HELD into the roots, where that pays in a step with so many evaluations of them. */
held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations);

#endif
