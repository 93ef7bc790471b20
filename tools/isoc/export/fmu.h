/* Shared by the files that write an FMU. */
#ifndef ISOC_EXPORT_FMU_H
#define ISOC_EXPORT_FMU_H

#include "tools/isoc/export/terminals.h"

typedef struct fmu {
    const plant *p;
    const graph *g;
    const naming *names;
    arena *memory;
    const char *identity; /* 16 digits */
    int version;          /* of the standard: 2 or 3 */
    bool exchanges;       /* for model exchange too */
} fmu;

/* fmu_depends.c: the inputs, tunables and states that a formula reads in a row, directly or through others of the same
 * row, and whether it reads the time; at the start, or in a later row. */
typedef struct fmu_readings {
    bool time;
    const bool *inputs, *parameters, *states;
} fmu_readings;

fmu_readings fmu_depends(const fmu *f, node root, bool at_start);

/* fmu_model.c: fmu_model.h, the model in C, by tools/fmu/model.h.in. */
void fmu_add_model(const fmu *f, file_list *files);
/* The kind of each state, by the constants of that file: turns and quaternions are corrected now and then. */
const char *fmu_kinds(const fmu *f);
/* A line for each source that a compiler takes; `line` has %s in the place of its path. */
const char *fmu_sources(const fmu *f, const char *line);

/* fmu_description.c: modelDescription.xml. */
void fmu_describe(const fmu *f, file_list *files);

#endif
