/* Functions of time in formulas: nodes that are functions of the tick. */
#ifndef ISOC_FORMULA_TIMING_H
#define ISOC_FORMULA_TIMING_H

#include "tools/isoc/formula/value.h"

/* `time`; sin(3 Hz), cos(3 Hz, 90 deg), sin(2 rad/s); table(0 s: 0 N, 1 s: 8 N), ramp(0 s: 0 N, 1 s: 8 N). Count 0 after
 * noting a problem. */
value time_of_formula(values *v, const formula *f);
value wave_of_formula(values *v, const formula *f);
value noise_of_formula(values *v, const formula *f); /* noise(7) */
value points_of_formula(values *v, const formula *f);

/* The seed of a call of noise; false after noting a problem. And the noise that it gives. */
bool noise_seed(values *v, const formula *f, uint32_t *seed);
node noise_of_seed(graph *g, uint32_t seed);

/* Whether a function of time stands where an input of its own is made of it: in effects, signals and outputs. */
bool is_time_input(const values *v);

/* Whether a formula must not depend on time; then it notes a problem. */
bool refuses_time(values *v, const formula *f);

/* The turns in a tick of a frequency; false after noting a problem. */
bool turns_in_tick(values *v, const formula *f, double *turns);

#endif
