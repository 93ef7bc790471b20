/* The states that take sub-steps of their own in a step, and the others that their derivatives read: what
 * core/methods/multirate.h is told of a plant. */
#ifndef ISOC_PLANT_FAST_H
#define ISOC_PLANT_FAST_H

#include "tools/isoc/graph/graph.h"
#include "tools/isoc/mechanism/mechanism.h"

typedef struct fast_part {
    int *states;
    int count; /* 0: none do */
    int *reads;
    int read_count;
    node *derivatives; /* of these states */
} fast_part;

/* From the derivatives of all states. */
fast_part fast_build(const graph *g, const mechanism *m, const node *derivatives);

#endif
