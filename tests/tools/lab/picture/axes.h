/* An axis, read by the labels of its tics.
 *
 * A point and the two labels that it is measured by are each at most RESOLUTION off; with s the place of the point
 * between the two, 0 and 1, that is RESOLUTION (1 + |s| + |1 - s|) in all. */
#ifndef ISO_TESTS_PICTURE_AXES_H
#define ISO_TESTS_PICTURE_AXES_H

#include <stdbool.h>
#include <stddef.h>

enum { LABELS_MOST = 16 };

typedef struct axis {
    size_t labels;
    double pixel[LABELS_MOST];
    double value[LABELS_MOST];
    bool powers; /* a label has a power of ten */
    bool logarithmic;
} axis;

/* Adds a label at a pixel; false if it is no number, or one too many. */
bool axis_label(axis *a, double pixel, const char *text);

/* Finds whether an axis is linear or logarithmic. If its labels do not say it, false, with a line that names the axis,
 * and the panel by its title. */
bool axis_scale(axis *a, const char *title, const char *name);

/* Where a value stands on an axis, between its first and its last label or beyond, and how far off that may be. */
double pixel_of(const axis *a, double value, double *tolerance);

double value_of(const axis *a, double pixel);

#endif
