/* What the parts of an FMU are written from. */
#ifndef ISOC_EMIT_FMU_H
#define ISOC_EMIT_FMU_H

#include "tools/isoc/emit/parts.h"

typedef struct fmu {
    const plant *p;
    const naming *names;
    arena *memory;
    const char *identity; /* 16 digits */
    int version;          /* of the standard: 2 or 3 */
} fmu;

/* A line for each source that a compiler takes; `line` has %s in the place of its path. */
const char *fmu_sources(const fmu *f, const char *line);

/* fmu_description.c: modelDescription.xml. */
void fmu_describe(const fmu *f, text *out);

#endif
