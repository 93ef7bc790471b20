#include "tools/isoc/base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void text_add(text *t, const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const size_t left = t->room - t->length;
    const size_t length = (size_t)vsnprintf(left > 0 ? t->bytes + t->length : NULL, left, format, arguments);
    va_end(arguments);
    if (length >= left) {
        t->bytes = arena_grow(t->memory, t->bytes, t->length + length, &t->room, 1);
        vsnprintf(t->bytes + t->length, length + 1, format, again);
    }
    va_end(again);
    t->length += length;
}

/* The filling of the hole that begins at an @; the last of them if it is none. */
static const filling *filling_of(const char *at, const filling *f)
{
    while (f->hole != NULL && (strncmp(at + 1, f->hole, strlen(f->hole)) != 0 || at[1 + strlen(f->hole)] != '@')) {
        f++;
    }
    return f;
}

void text_fill(text *t, const char *template, const filling *fillings)
{
    for (const char *at = template; *at != '\0';) {
        const filling *f = at[0] == '@' ? filling_of(at, fillings) : NULL;
        if (f != NULL && f->hole != NULL) {
            text_add(t, "%s", f->words);
            at += strlen(f->hole) + 2;
        } else {
            const size_t length = 1 + strcspn(at + 1, "@");
            text_add(t, "%.*s", (int)length, at);
            at += length;
        }
    }
}

size_t index_of_word(const char *word, const char *const *words, size_t count)
{
    size_t found = 0;
    while (found < count && (word == NULL || strcmp(word, words[found]) != 0)) {
        found++;
    }
    return found;
}

const char *listed(arena *memory, const char *const *words, size_t count, const char *last)
{
    const char *list = words[0];
    for (size_t i = 1; i < count; i++) {
        list = i + 1 < count ? arena_format(memory, "%s, %s", list, words[i])
                             : arena_format(memory, "%s %s %s", list, last, words[i]);
    }
    return list;
}

const char *alternatives(arena *memory, const char *const *words, size_t count)
{
    return listed(memory, words, count, "or");
}
