/* Values that do not change within a step stand in an array h for all evaluations of the derivative. What follows from tunables
 * alone is computed when one changes; behind it is what a step computes once, from that, held inputs and memories. */
#ifndef ISOC_PLANT_HELD_H
#define ISOC_PLANT_HELD_H

#include "tools/isoc/graph/graph.h"
#include "tools/isoc/mechanism/mechanism.h"

typedef struct held {
    node *values; /* h: of tunables, then of h, inputs and memories */
    int tuned;    /* how many are of tunables alone */
    int count;    /* 0: nothing is held, as that would not pay */
} held;

/* Puts leaves OP_HELD into the roots, where that pays in a step with so many evaluations of them. */
held held_build(graph *g, const mechanism *m, node *roots, size_t count, int evaluations);

#endif
