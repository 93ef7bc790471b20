/* Lists of things of one type, which grow. */
#ifndef ISOC_BASE_LIST_H
#define ISOC_BASE_LIST_H

#include "tools/isoc/base/arena.h"

/* As a type of a member, or of a variable. */
#define LIST_OF(TYPE)                                                                                                  \
    struct {                                                                                                           \
        TYPE *all;                                                                                                     \
        size_t count, room;                                                                                            \
    }

/* Adds a thing behind the others. */
#define LIST_ADD(memory, list, thing)                                                                                  \
    ((list).all = arena_grow(memory, (list).all, (list).count, &(list).room, sizeof *(list).all),                      \
     (list).all[(list).count++] = (thing))

/* for each thing of a list, and of an array of so many: FOR_EACH(const body, b, written->bodies) { ... }. It is a pointer
 * into the list, which must not grow meanwhile. */
#define FOR_EACH(TYPE, thing, list) FOR_ALL (TYPE, thing, (list).all, (list).count)
#define FOR_ALL(TYPE, thing, first, number)                                                                            \
    for (TYPE *thing = (first); thing != NULL && thing < (first) + (number); thing++)

#endif
