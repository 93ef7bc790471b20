#include "tools/isoc/base/arena.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK_BYTES = 1 << 16, LARGE_BYTES = 1 << 12 }; /* a large piece has a block of its own */

typedef struct block {
    struct block *next, *before;
    max_align_t bytes[];
} block;

struct arena {
    block *blocks;
    char *free; /* the free end of the block that small pieces come from */
    size_t left;
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

static void *link_block(arena *a, block *b)
{
    b->next = a->blocks;
    b->before = NULL;
    if (b->next != NULL) {
        b->next->before = b;
    }
    a->blocks = b;
    return b->bytes;
}

/* The block of a large piece, no longer in the list. */
static block *unlink_block(arena *a, void *bytes)
{
    block *b = (block *)((char *)bytes - offsetof(block, bytes));
    *(b->before == NULL ? &a->blocks : &b->before->next) = b->next;
    if (b->next != NULL) {
        b->next->before = b->before;
    }
    return b;
}

static bool is_large(size_t count, size_t size)
{
    return size != 0 && count > LARGE_BYTES / size;
}

/* The bytes of a large piece and its block. */
static size_t block_bytes(size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - sizeof(block)) / size) {
        must(NULL);
    }
    return sizeof(block) + count * size;
}

void *arena_take(arena *a, size_t count, size_t size)
{
    if (is_large(count, size)) {
        return link_block(a, must(calloc(1, block_bytes(count, size))));
    }
    const size_t part = sizeof(max_align_t), bytes = (count * size + part - 1) / part * part;
    if (bytes > a->left) {
        a->free = link_block(a, must(calloc(1, sizeof(block) + BLOCK_BYTES)));
        a->left = BLOCK_BYTES;
    }
    void *taken = a->free;
    a->free += bytes;
    a->left -= bytes;
    return taken;
}

void arena_return(arena *a, void *items, size_t count, size_t size)
{
    if (is_large(count, size)) {
        free(unlink_block(a, items));
    }
}

void *list_copy(arena *a, const void *items, size_t count, size_t size)
{
    void *copy = arena_take(a, count + 1, size);
    if (count > 0) {
        memcpy(copy, items, count * size);
    }
    return copy;
}

char *arena_copy(arena *a, const char *text, size_t length)
{
    return list_copy(a, text, length, 1);
}

char *arena_format_list(arena *a, const char *format, va_list arguments)
{
    char buffer[128]; /* a text that fits is formatted once */
    va_list again;
    va_copy(again, arguments);
    const size_t length = (size_t)vsnprintf(buffer, sizeof buffer, format, arguments);
    char *text = arena_take(a, length + 1, 1);
    if (length < sizeof buffer) {
        memcpy(text, buffer, length);
    } else {
        vsnprintf(text, length + 1, format, again);
    }
    va_end(again);
    return text;
}

char *arena_format(arena *a, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = arena_format_list(a, format, arguments);
    va_end(arguments);
    return text;
}

void *arena_grow(arena *a, void *items, size_t count, size_t *room, size_t size)
{
    if (count < *room) {
        return items;
    }
    const size_t before = *room;
    do {
        *room = *room == 0 ? 16 : 2 * *room;
    } while (count >= *room);
    if (is_large(before, size)) {
        const size_t bytes = block_bytes(*room, size);
        void *larger = link_block(a, must(realloc(unlink_block(a, items), bytes)));
        memset((char *)larger + before * size, 0, (*room - before) * size);
        return larger;
    }
    void *larger = arena_take(a, *room, size);
    if (before != 0) {
        memcpy(larger, items, before * size);
    }
    return larger;
}
