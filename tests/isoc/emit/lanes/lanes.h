/* Plants whose inputs, tunables, faults and ends follow from a number: each alone, or all in lanes. */
#ifndef ISOCHRON_TESTS_LANES_LANES_H
#define ISOCHRON_TESTS_LANES_LANES_H

#include <stdint.h>

enum { MOST_LANES = 32 };

/* What became of a plant. */
typedef struct outcome {
    uint64_t hash;       /* of states, inputs with memories, and outputs in all ticks, */
    uint64_t last;       /* and of what they are at the end */
    uint64_t stopped_at; /* the tick that ended at the guard; 0: none */
    uint64_t restarts, outputs_held, near_singular, violated;
    uint64_t held[2], clamped[2]; /* inputs and tunables */
    double local_error, violation;
} outcome;

/* Runs plants number 0, 1, ... for so many ticks; `lanes` is how many. */
typedef void runner(uint64_t ticks, unsigned lanes, outcome *out);
runner run_alone, run_lanes;

/* A number that looks random, for each place, tick and plant. */
static inline uint64_t number_at(const uint64_t place, const uint64_t tick, const unsigned plant)
{
    uint64_t z = (place * 1000003 + tick) * 64 + plant + UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

#endif
