/* The rates of outputs: which are computed in each tick, and which in every fourth. */
#ifndef ISOC_PLANT_RATES_H
#define ISOC_PLANT_RATES_H

#include "tools/isoc/plant/plant.h"

/* The outputs of one rate. */
typedef struct output_rate {
    double every; /* ticks */
    int *which;   /* [count] outputs of the plant */
    node *roots;  /* [count] */
    int count;
} output_rate;

typedef struct output_rates {
    output_rate *all; /* the fastest first */
    int count;
} output_rates;

output_rates output_rates_of(const plant *p, arena *memory);

/* Whether some output is not computed in each tick. */
bool has_slow_outputs(const mechanism *m);

#endif
