/* Blocks: words, each with its value, in any order, each at most once; { mass 1 kg; com (0, 0, 1) m }. A scene is one
 * too, without braces. What words there are, and for which kind of joint or closure, stands in one table each. */
#ifndef ISOC_SCENE_BLOCK_H
#define ISOC_SCENE_BLOCK_H

#include "tools/isoc/scene/take.h"

/* Reads the value that follows `word` into its slot. */
typedef void property_reader(parser *p, const token *word, void *slot);

typedef struct property {
    const char *word;
    property_reader *read;
    size_t slot;        /* its offset in the struct that is filled */
    unsigned kinds;     /* that have it: those with one of these traits; and MANY where it may come more than once */
    const char *needed; /* where none of them can be without it: an example */
} property;

enum { EVERY_KIND = 0xFFFF, MANY = 0x10000, MOST_KINDS = 16 };

typedef struct block {
    const char *what;  /* joint */
    const void *kinds; /* structs that begin with their word, of this size each */
    size_t kind_size;
    size_t kind_count;               /* 0: there is but one, which has no name */
    unsigned (*traits)(size_t kind); /* NULL: a bit for each kind */
    const property *properties;
    size_t property_count;
} block;

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

/* The kind, which follows the name. An unknown one is noted as a problem; then the result is kind_count, which has all
 * properties and needs none. */
size_t parse_kind(parser *p, const block *b);

/* { property ... } of a thing called `whose`, into the struct `to`. Returns whether all could be read and nothing is
 * missing. */
bool parse_block(parser *p, const block *b, size_t kind, name whose, void *to);

/* One statement after the other, to the end. Returns whether all could be read. */
bool parse_statements(parser *p, const block *statements, void *to);

/* Whether b has this word, for any kind. */
bool block_has_word(const block *b, const token *t);

/* Readers of what is the same in many blocks; their slots are a formula *, or a name. */
property_reader read_formula, read_axis, read_input, read_joint;

#endif
