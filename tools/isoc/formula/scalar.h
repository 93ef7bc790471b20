/* Scalars of formulas, and what their dimensions are. */
#ifndef ISOC_FORMULA_SCALAR_H
#define ISOC_FORMULA_SCALAR_H

#include "tools/isoc/formula/value.h"

static const dimension plain = {0, 0, 0, 0, 0, 0, 0}, second = {0, 0, 1, 0, 0, 0, 0}, radian = {0, 0, 0, 1, 0, 0, 0};
static const double pi = 3.14159265358979323846;
static const double most_ticks = 4e9; /* of 2^32 */

static inline value scalar(node n, dimension of)
{
    return (value){.count = 1, .parts = {n}, .of = of};
}

#endif
