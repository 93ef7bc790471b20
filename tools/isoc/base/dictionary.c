#include "tools/isoc/base/dictionary.h"

#include <stdint.h>
#include <string.h>

/* Where a name stands, or could: the size is a power of two, and at least one slot in two is free. FNV-1a: Fowler, Noll
 * and Vo (1991). */
static dictionary_entry *slot_of(const dictionary *d, const char *name)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (const char *c = name; *c != '\0'; c++) {
        hash = (hash ^ (unsigned char)*c) * UINT64_C(0x100000001b3);
    }
    size_t slot = (size_t)(hash ^ (hash >> 32)) & (d->size - 1);
    while (d->entries[slot].name != NULL && strcmp(d->entries[slot].name, name) != 0) {
        slot = (slot + 1) & (d->size - 1);
    }
    return &d->entries[slot];
}

static void grow(dictionary *d)
{
    const dictionary old = *d;
    d->size = old.size == 0 ? 64 : 2 * old.size;
    d->entries = arena_take(d->memory, d->size, sizeof *d->entries);
    for (size_t i = 0; i < old.size; i++) {
        if (old.entries[i].name != NULL) {
            *slot_of(d, old.entries[i].name) = old.entries[i];
        }
    }
    arena_return(d->memory, old.entries, old.size, sizeof *old.entries);
}

int *dictionary_find(const dictionary *d, const char *name)
{
    dictionary_entry *e = d->size == 0 ? NULL : slot_of(d, name);
    return e == NULL || e->name == NULL ? NULL : &e->number;
}

void dictionary_put(dictionary *d, const char *name, int number)
{
    if (2 * (d->count + 1) > d->size) {
        grow(d);
    }
    *slot_of(d, name) = (dictionary_entry){name, number};
    d->count++;
}
