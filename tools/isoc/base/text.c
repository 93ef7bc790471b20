#include "tools/isoc/base/text.h"

#include <stdarg.h>
#include <stdio.h>

void text_add(text *t, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const size_t length = (size_t)vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    t->bytes = arena_grow(t->memory, t->bytes, t->length + length, &t->room, 1);
    vsnprintf(t->bytes + t->length, length + 1, format, again);
    va_end(again);
    t->length += length;
}

const char *alternatives(arena *memory, const char *const *words, size_t count)
{
    const char *list = words[0];
    for (size_t i = 1; i < count; i++) {
        list = arena_format(memory, "%s%s%s", list, i + 1 < count ? ", " : " or ", words[i]);
    }
    return list;
}
