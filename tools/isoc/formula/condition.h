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

#endif
