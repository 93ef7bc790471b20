/* Files that are read whole, and the end of the program when something does not fit. */
#ifndef ISO_TESTS_PICTURE_FILE_H
#define ISO_TESTS_PICTURE_FILE_H

#include <stddef.h>

_Noreturn void fail(const char *what);

/* Memory for `count` things of this size, all zero; to be freed. */
void *memory_of(size_t count, size_t size);

/* A file's text; to be freed. */
char *read_all(const char *path);

/* The number of one more thing of a list that has room for `most`; `what` is said when it is full. */
size_t one_more(size_t *count, size_t most, const char *what);

#endif
