/* The points of a picture, each with its panel and the name of its curve. */
#ifndef ISO_TESTS_PICTURE_CURVES_H
#define ISO_TESTS_PICTURE_CURVES_H

#include "tests/tools/lab/picture/panels.h"

typedef struct point {
    const panel *panel;
    const char *curve; /* empty if no legend names it */
    double x, y;       /* the values, of a point that is expected */
    place at;
} point;

typedef struct points {
    point *all;
    size_t count;
} points;

/* The points that are drawn, curve by curve; to be freed. */
points read_points(const drawing *d, const panels *of);

#endif
