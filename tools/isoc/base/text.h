/* Text that grows. */
#ifndef ISOC_BASE_TEXT_H
#define ISOC_BASE_TEXT_H

#include "tools/isoc/base/arena.h"

typedef struct text {
    arena *memory;
    char *bytes;
    size_t length, room;
} text;

/* Adds formatted text, as printf. */
void text_add(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The text for a hole of a template, @name@; the last of an array has none. */
typedef struct filling {
    const char *hole, *words;
} filling;

/* Adds a template with its named places filled. All other text of the template is copied. */
void text_fill(text *t, const char *template, const filling *fillings);

/* Where a word stands among others, or their number. */
size_t index_of_word(const char *word, const char *const *words, size_t count);

/* The words as a person lists them: a, b and c, with `last` before the last one; and with "or". */
const char *listed(arena *memory, const char *const *words, size_t count, const char *last);
const char *alternatives(arena *memory, const char *const *words, size_t count);

#endif
