/* The page: a template with runs put in. */
#ifndef ISO_TOOLS_SHOW_PAGE_H
#define ISO_TOOLS_SHOW_PAGE_H

#include <stdio.h>

#include "tools/show/view.h"

/* A run with what it is called. */
typedef struct run {
    const char *label;
    shape shape;
    record record;
    figure figure;
} run;

/* All runs as one object of JSON; they are seen by the camera of the first. */
void page_data(FILE *out, const run *runs, size_t count);

/* The page: of a folder page.html, with page.css and the scripts in it. */
void page_write(FILE *out, const char *folder, const run *runs, size_t count);

#endif
