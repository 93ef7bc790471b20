/* What programs on the host share: files that are read whole, or that take their name when they are whole; a message
 * and the end; a clock. */
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

/* All of a file, with a final zero that *bytes does not count; in memory that is the caller's to free. NULL, with
 * errno, if it cannot be read. */
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

/* Gives it its name. False, with errno, where not all is written: then the file of that name stays as it was. */
bool file_end(new_file *f);

/* The same of a program that ends with a message where it cannot. */
void file_must_begin(new_file *f, const char *program, const char *folder, const char *name, const char *suffix);
void file_must_end(new_file *f, const char *program);

/* Leaves the file of that name as it was. */
void file_drop(new_file *f);

/* Seconds of a clock that only goes on. */
double seconds_now(void);

#endif
