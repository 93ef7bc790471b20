/* The text of core's files, for plants that stand alone; tools/build/embed.sh writes them down. */
#ifndef ISOC_EMIT_CORE_FILES_H
#define ISOC_EMIT_CORE_FILES_H

typedef struct core_file {
    const char *path; /* core/runtime/plant.h; NULL after the last */
    const char *text;
} core_file;

extern const core_file core_files[];

#endif
