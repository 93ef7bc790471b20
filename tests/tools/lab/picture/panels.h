/* The panels of a drawing, each with its title and its two axes. */
#ifndef ISO_TESTS_PICTURE_PANELS_H
#define ISO_TESTS_PICTURE_PANELS_H

#include "tests/tools/lab/picture/axes.h"
#include "tests/tools/lab/picture/svg.h"

#define ABOVE 40.0 /* a panel's title and its own legend are at most so far above it */

enum { PANELS_MOST = 64 };

typedef struct panel {
    double left, right, top, bottom;
    axis x, y;
    const char *title, *abscissa;
} panel;

typedef struct panels {
    panel all[PANELS_MOST];
    size_t count;
} panels;

/* Finds the panels. If an axis cannot be read, false, with a line for each. */
bool read_panels(panels *of, const drawing *d);

/* The number of the panel at this place, -1 if there is none. */
int panel_at(const panels *of, place at);

/* The number of the panel with this name, TITLE|LABEL OF THE ABSCISSA; -1 if there is none. */
int panel_named(const panels *of, const char *name);

#endif
