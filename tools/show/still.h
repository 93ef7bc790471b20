/* A figure at one time as SVG. */
#ifndef ISO_TOOLS_SHOW_STILL_H
#define ISO_TOOLS_SHOW_STILL_H

#include <stdio.h>

#include "tools/show/view.h"

/* The colours of the inks, red, green and blue. */
enum { INKS = INK_SPRING + 1 };
extern const int ink_colours[INKS][3];

void still_write(FILE *out, const shape *s, const record *r, const figure *f, const view *v, double seconds);

#endif
