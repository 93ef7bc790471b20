/* Measured signals in formulas: file "road.csv". */
#ifndef ISOC_MECHANISM_MEASURED_H
#define ISOC_MECHANISM_MEASURED_H

#include "tools/isoc/mechanism/value.h"

/* Straight lines between the points of the file; constant before the first and after the last. Count 0 after noting a
 * problem, at its place in the file. */
value file_of_formula(values *v, const formula *f);

#endif
