/* Functions in formulas: sqrt(2), atan2(3 mm, 4 mm), sin(30 deg), and those of time. */
#ifndef ISOC_FORMULA_FUNCTIONS_H
#define ISOC_FORMULA_FUNCTIONS_H

#include "tools/isoc/formula/value.h"

/* The value of a call. Count 0 after noting a problem. */
value call_of_formula(values *v, const formula *f);

/* Of a comparison: 1 or 0. */
value order_of_formula(values *v, const formula *f);

#endif
