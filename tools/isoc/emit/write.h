/* Where isoc writes: the files of a plant, and standard output. */
#ifndef ISOC_EMIT_WRITE_H
#define ISOC_EMIT_WRITE_H

#include <stdbool.h>

#include "tools/isoc/base/text.h"

/* Makes the folder, with those above it. Each of these returns false after saying on stderr why it could not. */
bool write_folder(arena *memory, const char *path);

/* Writes folder/base: beside it first, then by a new name, so that a half-written file is never seen. */
bool write_file(arena *memory, const char *folder, const char *base, const text *t);

/* Writes to standard output, to the end. */
bool write_out(const char *bytes, size_t length);

#endif
