/* How the runs of a plant are made. alone.c makes one after the other; side.c, compiled with ISO_LANES, as many side by
 * side. A program has one of both, compiled as its plants are. What stands here does not depend on lanes, so that all
 * else of a sweep is compiled once. */
#ifndef SWEEP_STEPS_H
#define SWEEP_STEPS_H

#include <stdbool.h>
#include <stdint.h>

#include "core/numbers/real.h"

struct iso_plant;

/* A plant of the sweep, or the message with which isoc refused it. Its start, if it differs from another plant, whose
 * code it uses, in the start only; else NULL. */
typedef struct sweep_plant {
    const struct iso_plant *plant;
    const char *refusal;
    const iso_scalar *start;
} sweep_plant;

/* All plants, and the duration of each run: tools/lab/sweep.py writes them. */
extern const sweep_plant sweep_plants[];
extern const uint64_t sweep_duration_ns;

/* Of a plant, what the table needs: core/runtime/plant.h. */
typedef struct plant_facts {
    const char *name, *state_names, *output_names;
    uint16_t outputs, parameters;
    const iso_scalar *defaults;
} plant_facts;

/* What the table shows of an output. */
enum { SHOWS_LAST = 1, SHOWS_EXTREMES = 2, SHOWS_SUMS = 4 };

/* What the table shows, so that nothing else is computed. */
typedef struct shown {
    bool hash;
    const uint8_t *of_output; /* [outputs] a sum of SHOWS_... */
} shown;

/* An output over the rows of a run, from that of the start on. */
typedef struct seen {
    iso_scalar last, least, most;
    double sum, squares;
} seen;

/* How a run ended: at its duration; before its start, for a value that is beyond its limits or breaks a condition; or
 * at the guard. */
typedef enum ending { ENDS_WELL, ENDS_REFUSED, ENDS_NEAR, ENDS_NOT_FINITE, ENDS_OUT_OF_RANGE } ending;

/* A run: what it begins with, and its results. A run that failed has no outputs. */
typedef struct account {
    const sweep_plant *variant;
    iso_scalar *values; /* of the tunables */
    seen *outputs;
    uint64_t ticks, restarts, hash;
    bool is_made; /* or will be at once; not where isoc refused the plant */
    ending ending;
    uint16_t state; /* the first that was not finite or out of range */
} account;

/* How many runs are made at once. */
extern const unsigned steps_width;

/* Whether the processor, and the flags with which the plants were compiled, keep the bits of results. */
bool steps_keep_bits(void);

plant_facts steps_facts(const struct iso_plant *plant);

/* Makes runs[count], all of one plant; their accounts have `variant` and `values`, and zeros. */
void steps_make(const struct iso_plant *plant, account *const *runs, uint64_t count, const shown *what);

#endif
