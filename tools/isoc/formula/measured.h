/* Measured signals in formulas: file "road.csv". */
#ifndef ISOC_FORMULA_MEASURED_H
#define ISOC_FORMULA_MEASURED_H

#include "tools/isoc/formula/value.h"

/* Straight lines between the points of the file; constant before the first and after the last. Count 0 after noting a
 * problem, at its place in the file. */
value file_of_formula(values *v, const formula *f);

#endif
