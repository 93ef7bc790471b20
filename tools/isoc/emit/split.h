/* A long body in functions of bounded size: the time and the memory of a compiler grow faster than a function. */
#ifndef ISOC_EMIT_SPLIT_H
#define ISOC_EMIT_SPLIT_H

#include "tools/isoc/emit/code.h"

typedef struct code_part {
    const char *body;
    bool reads[OPERATIONS]; /* which leaves */
    bool sets;              /* some target */
    bool carries;           /* something from part to part, in v[] */
} code_part;

typedef struct code_parts {
    code_part *all;
    int count;
    int carried; /* reals of v[] */
} code_parts;

/* Parts of at most so many statements. What one declares and a later one reads stands in v[]. */
code_parts code_split(const code_pieces *pieces, int most);

#endif
