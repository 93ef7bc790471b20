/* Conditions: comparisons, and `and`, `or`, `not` of them. As numbers they are 1 or 0; as functions they are below zero
 * where they hold, and pass through zero where they begin to. */
#ifndef ISOC_FORMULA_CONDITION_H
#define ISOC_FORMULA_CONDITION_H

#include "tools/isoc/formula/value.h"

/* logic.c: 1 or 0 of conditions that are 1 or 0; and of a == b, which is of whole numbers. */
value logic_of(values *v, const formula *f, const value *arguments);
value equality_of(values *v, const formula *f, const value *both, node a, node b);

/* condition.c: the function of a condition. A < B has A - B, a == b |a - b| - 1/2; `and` is the larger of two
 * functions, `or` the smaller, `not` the negative. */
value condition_function(values *v, const formula *f);

/* shares.c: the part of a step in which a condition holds, as nodes of its values at the begin and of their changes in
 * the step (OP_CHANGE). */

enum { MOST_COMPARED = 8 };

/* The functions of the comparisons that a share(A < B and C < D) has, functions[MOST_COMPARED]; -1 after noting a
 * problem. */
int share_functions(values *v, const formula *f, node *functions);

/* The part of the step in which all of them are below zero. */
node share_of(graph *g, const node *functions, int count);

/* The same of a wave that is on in the first part `duty` of each period; `over` are the steps since its begin, of
 * `period` steps. */
node share_of_wave(graph *g, node duty, node over, double period);

/* Whether this is a call of pwm; the steps in its period, 0 after noting a problem; and as a function of the tick those
 * since its begin, count 0 likewise. */
bool is_wave(const formula *f);
double wave_period(values *v, const formula *f);
value wave_over(values *v, const formula *f);

#endif
