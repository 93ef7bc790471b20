/* Tables of a quantity in formulas: table(x, 0 m: 0 N, 10 mm: 8 N). */
#ifndef ISOC_MECHANISM_TABLE_H
#define ISOC_MECHANISM_TABLE_H

#include "tools/isoc/mechanism/value.h"

/* Straight lines between the points; outside of them the end values. Its places are constants, its values may be tunable.
 * Count 0 after noting a problem. */
value table_of_formula(values *v, const formula *f);

#endif
