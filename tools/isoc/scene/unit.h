/* Units: the factor and dimension of a name like mm, kg, rpm or V in m, kg, s, rad, A and K. */
#ifndef ISOC_SCENE_UNIT_H
#define ISOC_SCENE_UNIT_H

#include <stdbool.h>
#include <stdint.h>

#include "tools/isoc/base/arena.h"

/* Exponents in halves: 4 is a square, 1 a root, as of the time in a density of noise. The angle is a dimension, so that
 * N*m and N*m/rad are different. */
typedef struct dimension {
    int8_t kg, m, s, rad, A, K;
} dimension;

/* Of whole exponents, and the largest one. */
#define DIMENSION(kg, m, s, rad, A, K)                                                                                 \
    {                                                                                                                  \
        2 * (kg), 2 * (m), 2 * (s), 2 * (rad), 2 * (A), 2 * (K)                                                        \
    }
enum { MOST_POWER = 60 };

/* A unit is numerator / denominator times the SI unit of its dimension: mm is 1/1000 m, deg is pi/180 rad; two numbers
 * keep 431.8 mm the nearest double to 0.4318 m. `zero` is where its scale begins, in hundredths of the SI unit: 27315
 * of degC. */
typedef struct unit {
    double numerator, denominator;
    dimension dim;
    double zero;
} unit;

/* The unit of a plain number. */
extern const unit unit_one;

bool dimension_equal(dimension a, dimension b);

/* The same, where a radian is the number one, as in the SI: N*m/A is V*s/rad. */
bool dimension_equal_but_angle(dimension a, dimension b);

/* a times b to the power n. Returns false where an exponent is beyond MOST_POWER. */
bool dimension_times(dimension *a, dimension b, int n);

/* The dimension as its field writes its unit, which the scene language reads as the same dimension: N*m/rad, V*s/rad,
 * 1/m, kg*m^2; or "a plain number". Where torque and energy agree, torque is meant. */
const char *dimension_text(arena *memory, dimension d);

/* The same without the radians that a product of formulas has gathered: N*m of N*m*rad, m/s of m*rad/s. */
const char *dimension_text_but_angle(arena *memory, dimension d);

/* Its unit in a header or a trace: N*m/rad, or 1. */
const char *dimension_unit(arena *memory, dimension d);

/* "is in N*m/rad", or "has no unit". */
const char *dimension_phrase(arena *memory, dimension d);

/* The unit of the rate of a quantity, from its unit: m/s of m, m/s^2 of m/s. */
const char *unit_of_rate(arena *memory, const char *base);

/* Whether it has no halves; and its root. Returns false where it has some. */
bool dimension_is_whole(dimension d);
bool dimension_root(dimension d, dimension *root);

/* Finds a unit by name, with an SI prefix where it takes one. */
bool unit_find(const char *name, unit *found);

/* The common units: a parameter must not have such a name, and a misspelt unit is compared with them. */
const char *const *unit_names(size_t *count);

#endif
