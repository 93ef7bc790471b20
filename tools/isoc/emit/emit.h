/* The generated plant: a header that names what is in its arrays, and a source that computes it. */
#ifndef ISOC_EMIT_EMIT_H
#define ISOC_EMIT_EMIT_H

#include "tools/isoc/emit/naming.h"

void emit_header(const plant *p, const naming *names, text *out);

/* Returns false, with *out_of_range_value, if a constant leaves the range of real. */
bool emit_source(const plant *p, graph *g, const naming *names, text *out, double *out_of_range_value);

#endif
