/* Numbers by name. */
#ifndef ISOC_BASE_DICTIONARY_H
#define ISOC_BASE_DICTIONARY_H

#include "tools/isoc/base/arena.h"

typedef struct dictionary_entry {
    const char *name; /* NULL: the slot is free */
    int number;
} dictionary_entry;

/* With its memory set and all else zero, it is empty. */
typedef struct dictionary {
    arena *memory;
    dictionary_entry *entries; /* open addressing */
    size_t count, size;
} dictionary;

/* The number of a name, to read or to change until another name is put; NULL where the name is not there. */
int *dictionary_find(const dictionary *d, const char *name);

/* Puts a name that is not there yet; it must last as long as the dictionary. */
void dictionary_put(dictionary *d, const char *name, int number);

#endif
