/* Elementary functions of constants, with the same bits on every host: + - * / and sqrt in pairs of doubles, whose
 * error is below 2^-90 of the result, rounded once. So a result is the nearest double, but where the exact one is
 * within 2^-36 ulp of the middle between two (tests/language/elementary.c). No host's libm takes part.
 */
#ifndef ISOC_BASE_ELEMENTARY_H
#define ISOC_BASE_ELEMENTARY_H

/* |x| <= 700. */
double elementary_exp(double x);

/* x > 0, normal. */
double elementary_log(double x);

/* The angle of the point (x, y) from the x axis, in [-pi, pi]; x and y are not both zero. */
double elementary_atan2(double y, double x);

/* |x| <= 1. */
double elementary_asin(double x);
double elementary_acos(double x);

#endif
