/* The points that are drawn against those that are expected. */
#ifndef ISO_TESTS_PICTURE_COMPARE_H
#define ISO_TESTS_PICTURE_COMPARE_H

#include "tests/tools/lab/picture/curves.h"

/* Reads the points that are expected, a line for each: panel, curve, abscissa, ordinate, separated by tabs. They point
 * into the text, which is changed. If there is no panel of a name, false, with a line that says so. */
bool read_expected(points *expected, const panels *of, char *text);

/* Whether every drawn point is expected; a line for each that is not. */
bool all_expected(const points *drawn, const points *expected);

/* Whether every point that is expected is drawn; a line for each that is not. */
bool all_drawn(const points *expected, const points *drawn);

#endif
