/* What a drawing has: paths and marks, texts, and the tics of axes with their labels. It is what
 * tools/lab/draw.py writes of gnuplot's drawing, with its axes.
 *
 * Coordinates have two decimals, so that each is at most RESOLUTION off. */
#ifndef ISO_TESTS_PICTURE_SVG_H
#define ISO_TESTS_PICTURE_SVG_H

#include <stdbool.h>
#include <stddef.h>

#define RESOLUTION 0.01
#define AXIS_COLOUR "#555555"
#define GRID_COLOUR "#d4d4d4"

enum { NAME_BYTES = 160, PLACES_MOST = 200000, ITEMS_MOST = 4000 };

typedef struct place {
    double x, y;
} place;

typedef struct words {
    place at;
    double size;
    char anchor; /* s, m or e: which end of it is there */
    bool upright;
    char text[NAME_BYTES];
} words;

/* A path, or a mark: then `mark` is its number and it has one place. */
typedef struct shape {
    char colour[8];
    int mark; /* -1 for a path */
    size_t first, places;
} shape;

/* A text that follows a tic is its label. */
typedef struct label {
    place tic;
    bool of_x;
    const words *text;
} label;

typedef struct drawing {
    double width, height;
    place places[PLACES_MOST];
    size_t place_count;
    words texts[ITEMS_MOST];
    size_t text_count;
    shape shapes[ITEMS_MOST];
    size_t shape_count;
    label labels[ITEMS_MOST];
    size_t label_count;
} drawing;

/* Reads the text of a drawing into an empty one. */
void read_drawing(drawing *d, const char *svg);

/* Whether two coordinates may be the same one. */
bool same(double a, double b);

#endif
