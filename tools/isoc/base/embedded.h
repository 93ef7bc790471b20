/* Files of the project that isoc has in it, so that it works alone; tools/build/embed.awk writes them down. */
#ifndef ISOC_BASE_EMBEDDED_H
#define ISOC_BASE_EMBEDDED_H

#include <string.h>

typedef struct embedded_file {
    const char *path; /* core/runtime/plant.h; NULL after the last */
    const char *text;
} embedded_file;

/* One by its path, which has this length; NULL where it is not there. */
static inline const embedded_file *embedded_find(const embedded_file *const files, const char *const path,
                                                 const size_t length)
{
    const embedded_file *f = files;
    while (f->path != NULL && (strlen(f->path) != length || strncmp(f->path, path, length) != 0)) {
        f++;
    }
    return f->path == NULL ? NULL : f;
}

/* The text of one that is there. */
static inline const char *embedded_text(const embedded_file *const files, const char *const path)
{
    return embedded_find(files, path, strlen(path))->text;
}

extern const embedded_file core_files[];   /* for plants that stand alone */
extern const embedded_file effect_files[]; /* models/effects: an effect each, called as its file */
extern const embedded_file client_files[]; /* tools/client: the controller's end of a link; and tools/package */
extern const embedded_file help_files[];   /* the text of --help */

#endif
