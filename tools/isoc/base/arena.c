#include "tools/isoc/base/arena.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct block {
    struct block *next;
    max_align_t bytes[];
} block;

struct arena {
    block *blocks;
};

static void *must(void *memory)
{
    if (memory == NULL) {
        fputs("isoc: out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

arena *arena_new(void)
{
    return must(calloc(1, sizeof(arena)));
}

void arena_free(arena *a)
{
    for (block *b = a->blocks; b != NULL;) {
        block *next = b->next;
        free(b);
        b = next;
    }
    free(a);
}

void *arena_take(arena *a, size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - sizeof(block)) / size) {
        must(NULL);
    }
    block *b = must(calloc(1, sizeof(block) + count * size));
    b->next = a->blocks;
    a->blocks = b;
    return b->bytes;
}

char *arena_copy(arena *a, const char *text, size_t length)
{
    char *copy = arena_take(a, length + 1, 1);
    memcpy(copy, text, length);
    return copy;
}

char *arena_format(arena *a, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    va_list again;
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    char *text = arena_take(a, (size_t)length + 1, 1);
    vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    return text;
}

void *arena_grow(arena *a, void *items, size_t count, size_t *room, size_t size)
{
    if (count < *room) {
        return items;
    }
    *room = *room == 0 ? 16 : 2 * *room;
    void *larger = arena_take(a, *room, size);
    if (count != 0) {
        memcpy(larger, items, count * size);
    }
    return larger;
}
