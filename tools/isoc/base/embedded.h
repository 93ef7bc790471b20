/* Files of the project that isoc has in it, so that it works alone; tools/build/embed.sh writes them down. */
#ifndef ISOC_BASE_EMBEDDED_H
#define ISOC_BASE_EMBEDDED_H

typedef struct embedded_file {
    const char *path; /* core/runtime/plant.h; NULL after the last */
    const char *text;
} embedded_file;

extern const embedded_file core_files[];   /* for plants that stand alone */
extern const embedded_file effect_files[]; /* models/effects: an effect each, called as its file */

#endif
