/* Functions shared by programs on the host: files that are read whole, or that get their name when they are whole; the
 * end of a program with a message; a clock. */
#ifndef ISO_TOOLS_FILE_FILE_H
#define ISO_TOOLS_FILE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { FILE_PATH_BYTES = 4096 };

/* Ends the program with a line on the standard error. */
__attribute__((format(printf, 1, 2))) _Noreturn void quit(const char *format, ...);

/* Memory for `count` items, all zero, which is the caller's to free; ends the program if there is none. */
void *memory_for(size_t count, size_t bytes);

/* A list of `count` items, NULL where it is empty, with room for one more behind them, where it stands now; ends the
 * program if there is none. */
void *room_behind(void *items, size_t count, size_t bytes);

/* The content of a file, with a final zero that *bytes does not count; the caller frees its memory. NULL, with errno,
 * if it cannot be read. */
char *file_rest(FILE *from, size_t *bytes);
char *file_content(const char *path, size_t *bytes);

/* A file that is written under the name `partial`, and has its own when it is whole. */
typedef struct new_file {
    char path[FILE_PATH_BYTES], partial[FILE_PATH_BYTES + 256];
    FILE *to; /* NULL: it is not open */
} new_file;

/* Opens FOLDER/NAME, or NAME where `folder` is NULL; its partial name has `.SUFFIX` behind that. False, with errno, if
 * it cannot. */
bool file_begin(new_file *f, const char *folder, const char *name, const char *suffix);

/* Gives the file its name. False, with errno, if not all is written: then the old file of that name stays. */
bool file_end(new_file *f);

/* The same; on failure the program ends with a message. */
void file_must_begin(new_file *f, const char *program, const char *folder, const char *name, const char *suffix);
void file_must_end(new_file *f, const char *program);

/* Drops the new file; the old file of that name stays. */
void file_drop(new_file *f);

/* Seconds of a clock that only goes on. */
double seconds_now(void);

#endif
