/* Test signals as functions of the tick: step, square, prbs, chirp. */
#ifndef ISOC_FORMULA_WAVEFORM_H
#define ISOC_FORMULA_WAVEFORM_H

#include "tools/isoc/formula/value.h"

/* step(0.5 s), square(2 Hz, 90 deg), prbs(7, 10 ms, 9), chirp(1 Hz, 50 Hz, 10 s). Count 0 after noting a problem. */
value waveform_of_formula(values *v, const formula *f);

/* Whether a formula is a function of time in an input, where alone it may be; else a problem is noted. */
bool is_in_input(values *v, const formula *f);

/* The first tick that is not before a time; a time that is a whole number of ticks but for the rounding of its unit counts
 * as that. And whether it is one. */
double first_tick_of(double ticks);
bool is_whole_tick(double ticks);

/* The table of a function, which it has been given before where the formula is evaluated again; or NULL. And a new one. */
const tick_table *table_made(const values *v, const formula *f);
tick_table *table_new(values *v, const formula *f, operation op);

/* The next evaluation of the formula has a table of its own: it is that of another effect. */
void tables_forget(values *v, const formula *f);

#endif
