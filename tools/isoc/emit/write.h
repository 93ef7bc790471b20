/* Where isoc writes: the files of a plant, and standard output. */
#ifndef ISOC_EMIT_WRITE_H
#define ISOC_EMIT_WRITE_H

#include <stdbool.h>

#include "tools/isoc/base/text.h"

typedef struct file_text {
    const char *path;
    text text;
} file_text;

/* Files that are written together. */
typedef struct file_list {
    arena *memory;
    const char *folder;
    file_text *files;
    size_t count, room;
} file_list;

/* `path` is that below the folder. */
void file_list_add(file_list *files, const char *path, const text *t);

/* The same of a template of tools/client, tools/fmu or tools/package, which is filled (text_fill). */
void file_list_fill(file_list *files, const char *path, const char *template, const filling *fillings);

/* A line of tools/build/numerics: the flags without which a compiler fuses, and without which a root calls libm. */
typedef enum flag_line { FLAGS_OF_FUSING, FLAGS_OF_ROOTS } flag_line;
const char *compiler_flags(arena *memory, flag_line which);

bool file_list_has(const file_list *files, const char *path);

/* A text of which nothing stands yet, with bytes to read all the same. */
static inline text empty_text(arena *memory)
{
    return (text){.memory = memory, .bytes = arena_copy(memory, "", 0)};
}

/* Writes all files beside those that are there, in folders that are made where they are missing, and then gives them
 * their names: where one cannot be written or named, all stay as they were. Like the next, returns false after saying
 * on stderr why it could not. */
bool write_files(const file_list *files);

/* Likewise a single file. */
bool write_file(arena *memory, const char *path, const text *t);

/* Writes to standard output, to the end. */
bool write_out(const char *bytes, size_t length);

#endif
