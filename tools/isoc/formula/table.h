/* Points in formulas: tables and ramps over time, tables of a quantity, table(x, 0 m: 0 N, 10 mm: 8 N), and of two. These
 * evaluate their own arguments. */
#ifndef ISOC_FORMULA_TABLE_H
#define ISOC_FORMULA_TABLE_H

#include "tools/isoc/formula/value.h"

/* Straight lines between the points; outside of them the end values. Its places are constants, its values may be tunable.
 * Count 0 after noting a problem. */
value table_of_formula(values *v, const formula *f);

/* table(x, y; 0 m, 1 m; 0 s: 1 N, 2 N; 1 s: 3 N, 5 N): the places of x, then for each place of y its value at each of them.
 * Bilinear in each cell, a x + b y + c x y + d; beyond the places that of the nearest. Likewise. */
value grid_of_formula(values *v, const formula *f);

/* table(0 s: 0 N, 1 s: 8 N), ramp(0 s: 0 N, 1 s: 8 N). Likewise. */
value points_of_formula(values *v, const formula *f);

#endif
