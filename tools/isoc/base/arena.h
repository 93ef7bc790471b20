/* Memory of one compilation: taken piece by piece, given back all at once. */
#ifndef ISOC_BASE_ARENA_H
#define ISOC_BASE_ARENA_H

#include <stddef.h>

typedef struct arena arena;

arena *arena_new(void);
void arena_free(arena *a);

/* Zeroed memory for `count` things of `size` bytes. Ends the program when there is none left. */
void *arena_take(arena *a, size_t count, size_t size);

/* A copy of the `length` bytes at `text`, ended by a zero. */
char *arena_copy(arena *a, const char *text, size_t length);

/* The text that printf would write. */
char *arena_format(arena *a, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* An array that grows: returns `items`, or a copy with twice the room when `count` items fill `room`. */
void *arena_grow(arena *a, void *items, size_t count, size_t *room, size_t size);

#endif
