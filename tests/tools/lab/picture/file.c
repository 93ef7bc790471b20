#include "tests/tools/lab/picture/file.h"

#include <stdio.h>
#include <stdlib.h>

_Noreturn void fail(const char *const what)
{
    fprintf(stderr, "picture: %s\n", what);
    exit(EXIT_FAILURE);
}

void *memory_of(const size_t count, const size_t size)
{
    void *const memory = calloc(count, size);
    if (memory == NULL) {
        fail("no memory");
    }
    return memory;
}

char *read_all(const char *const path)
{
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        fail(path);
    }
    size_t room = 1 << 20;
    size_t used = 0;
    char *text = memory_of(room, 1);
    for (;;) {
        used += fread(text + used, 1, room - 1 - used, file);
        if (used < room - 1) {
            break;
        }
        room *= 2;
        char *const larger = realloc(text, room);
        if (larger == NULL) {
            fail("no memory");
        }
        text = larger;
    }
    fclose(file);
    text[used] = '\0';
    return text;
}

size_t one_more(size_t *const count, const size_t most, const char *const what)
{
    if (*count == most) {
        fail(what);
    }
    return (*count)++;
}
