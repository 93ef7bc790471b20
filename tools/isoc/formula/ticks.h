/* Shared by functions of time in formulas: where they may stand, ticks, and the tables that they read. */
#ifndef ISOC_FORMULA_TICKS_H
#define ISOC_FORMULA_TICKS_H

#include "tools/isoc/formula/value.h"

/* Whether a function of time stands where an input of its own is made of it: in effects, signals and outputs. */
bool is_time_input(const values *v);

/* Whether a formula must not depend on time; then it notes a problem. */
bool refuses_time(values *v, const formula *f);

/* Whether a formula is a function of time in an input, where alone it may be; else a problem is noted. */
bool is_in_input(values *v, const formula *f);

/* Whether a number depends on the tick. And whether one of these values does where a function has a corner, in a motion; then
 * it notes a problem. */
bool depends_on_time(values *v, node n);
bool refuses_corner(values *v, const formula *f, const value *arguments, size_t count);

/* The name of a function in messages. */
const char *name_of(const formula *f);

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
