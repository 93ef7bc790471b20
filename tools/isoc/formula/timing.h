/* Functions of time in formulas: nodes that are functions of the tick. */
#ifndef ISOC_FORMULA_TIMING_H
#define ISOC_FORMULA_TIMING_H

#include "tools/isoc/formula/value.h"

/* `time`; and of evaluated arguments sin(3 Hz), cos(3 Hz, 90 deg), sin(2 rad/s), noise(7). Count 0 after noting a problem. */
value time_of_formula(values *v, const formula *f);
value wave_of_formula(values *v, const formula *f, const value *given, node (*of_angle)(graph *g, node angle));
value noise_of_formula(values *v, const formula *f, const value *given);

/* The seed of a call of noise; false after noting a problem. And the noise that it gives. */
bool noise_seed(values *v, const formula *f, const value *given, uint32_t *seed);
node noise_of_seed(graph *g, uint32_t seed);

/* The turns in a tick of a frequency; false after noting a problem. */
bool turns_in_tick(values *v, const formula *f, value frequency, double *turns);

#endif
