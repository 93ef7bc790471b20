/* Shared by functions of time in formulas: where they may stand, ticks, and the tables that they read. */
#ifndef ISOC_FORMULA_TICKS_H
#define ISOC_FORMULA_TICKS_H

#include "tools/isoc/formula/value.h"

/* Whether a function of time stands where an input of its own is made of it: in effects, signals and outputs. */
bool is_time_input(const values *v);

/* Whether a formula may depend on time; else a problem is noted. */
bool allows_time(values *v, const formula *f);

/* Whether a function of time stands in an input, the only place for it; else a problem is noted. */
bool is_in_input(values *v, const formula *f);

/* Whether one of these values depends on the tick where a function has a corner, in a motion; then it notes a problem.
 */
bool refuses_corner(values *v, const formula *f, const value *arguments, size_t count);

/* The name of a function in messages. */
const char *name_of(const formula *f);

/* The first tick that is not before a time; a time that is a whole number of ticks but for the rounding of its unit
 * counts as that. And whether it is one. */
double first_tick_of(double ticks);
bool is_whole_tick(double ticks);

/* A new table of the tick, of which *root is the function, of these two numbers. And the value of a call for which one
 * is made; it is found again where the formula is evaluated again. */
tick_table *table_new(values *v, operation op, double number, double other, node *root);
value value_with_table(values *v, const formula *f, node root);

/* That value's call; NULL where none is made. */
const table_call *table_made(const values *v, const formula *f);

/* The next evaluation of the formula has a table of its own: it is that of another effect. */
void tables_forget(values *v, const formula *f);

/* timing.c: functions of time in formulas: nodes that are functions of the tick. */

/* `time`; and of evaluated arguments sin(3 Hz), cos(3 Hz, 90 deg), sin(2 rad/s), noise(7). Count 0 after noting a
 * problem. */
value time_of_formula(values *v, const formula *f);
value wave_of_formula(values *v, const formula *f, const value *arguments, node (*of_angle)(graph *g, node angle));
value noise_of(values *v, const formula *f, const value *arguments);

/* The seed of a call of noise; false after noting a problem. And the noise that it gives. */
bool noise_seed(values *v, const formula *f, const value *arguments, uint32_t *seed);
node noise_of_seed(graph *g, uint32_t seed);

/* The turns in a tick of a frequency; false after noting a problem. */
bool turns_in_tick(values *v, const formula *f, value frequency, double *turns);

/* waveform.c: test signals as functions of the tick: step, square, prbs, chirp. */

/* step(0.5 s), square(2 Hz, 90 deg), prbs(7, 10 ms, 9), chirp(1 Hz, 50 Hz, 10 s), of evaluated arguments. Count 0 after
 * noting a problem. */
value step_of(values *v, const formula *f, const value *arguments);
value square_of(values *v, const formula *f, const value *arguments);
value prbs_of(values *v, const formula *f, const value *arguments);
value chirp_of(values *v, const formula *f, const value *arguments);

/* measured.c: measured signals in formulas: file "road.csv". Straight lines between the points of the file; constant
 * before the first and after the last. Count 0 after noting a problem, at its place in the file. */
value file_of_formula(values *v, const formula *f, const value *arguments);

/* table.c: points in formulas: tables and ramps over time, tables of a quantity, table(x, 0 m: 0 N, 10 mm: 8 N), and
 * of two. These evaluate their own arguments. */

/* Straight lines between the points; outside of them the end values. Its places are constants, its values may be
 * tunable. Count 0 after noting a problem. */
value table_of_formula(values *v, const formula *f);

/* table(x, y; 0 m, 1 m; 0 s: 1 N, 2 N; 1 s: 3 N, 5 N): the places of x, then for each place of y its value at each of
 * them. Bilinear in each cell, a x + b y + c x y + d; beyond the places that of the nearest. Likewise. */
value grid_of_formula(values *v, const formula *f);

/* table(0 s: 0 N, 1 s: 8 N), ramp(0 s: 0 N, 1 s: 8 N). Likewise. */
value points_of_formula(values *v, const formula *f);

#endif
