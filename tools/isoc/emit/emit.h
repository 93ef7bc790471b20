/* The generated plant: plant.h names what is in its arrays, plant.c computes it. */
#ifndef ISOC_EMIT_EMIT_H
#define ISOC_EMIT_EMIT_H

#include "tools/isoc/emit/code.h"
#include "tools/isoc/plant/plant.h"

/* The texts of the two files. Return false, with *culprit, if a constant leaves the range of real. */
bool emit_header(const plant *p, text *out);
bool emit_source(const plant *p, graph *g, text *out, double *culprit);

#endif
