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

#endif
