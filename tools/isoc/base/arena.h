/* Memory of one compilation: taken piece by piece, given back all at once, and large pieces before if they are no
 * longer needed. */
#ifndef ISOC_BASE_ARENA_H
#define ISOC_BASE_ARENA_H

#include <stdarg.h>
#include <stddef.h>

typedef struct arena arena;

arena *arena_new(void);
void arena_free(arena *a);

/* Zeroed memory for `count` things of `size` bytes. Ends the program when there is none left. */
void *arena_take(arena *a, size_t count, size_t size);

/* Frees the memory of `count` items of `size` bytes before the arena ends. Only a large piece is freed: small pieces
 * share a block with others. */
void arena_return(arena *a, void *items, size_t count, size_t size);

/* A copy of the `length` bytes at `text`, ended by a zero. */
char *arena_copy(arena *a, const char *text, size_t length);

/* A copy of these items, with a zeroed one behind them. */
void *list_copy(arena *a, const void *items, size_t count, size_t size);

/* The text that printf would write, and vprintf. */
char *arena_format(arena *a, const char *format, ...) __attribute__((format(printf, 2, 3)));
char *arena_format_list(arena *a, const char *format, va_list arguments) __attribute__((format(printf, 2, 0)));

/* An array that grows: `items`, or in their place a larger array that begins with them, so that it has room for more
 * than `count`. The old one is no longer there. */
void *arena_grow(arena *a, void *items, size_t count, size_t *room, size_t size);

/* Lists of things of one type, which grow: as a type of a member, or of a variable. */
#define LIST_OF(TYPE)                                                                                                  \
    struct {                                                                                                           \
        TYPE *all;                                                                                                     \
        size_t count, room;                                                                                            \
    }

/* Adds a thing behind the others; to a list, and to an array with a count and a room of its own. */
#define LIST_ADD(memory, list, thing) ADD_TO(memory, (list).all, (list).count, (list).room, thing)
#define ADD_TO(memory, array, number, room, thing)                                                                     \
    ((array) = arena_grow(memory, array, (size_t)(number), &(room), sizeof *(array)), (array)[(number)++] = (thing))

/* The number of the things of an array. */
#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/* for each thing of a list, and of an array of so many: FOR_EACH(const body, b, written->bodies) { ... }. It is a
 * pointer into the list, which must not grow meanwhile. */
#define FOR_EACH(TYPE, thing, list) FOR_ALL (TYPE, thing, (list).all, (list).count)
#define FOR_ALL(TYPE, thing, first, number)                                                                            \
    for (TYPE *thing = (first); thing != NULL && thing < (first) + (number); thing++)

#endif
