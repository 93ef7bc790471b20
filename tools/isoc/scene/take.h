/* Shared by all parts of the parser: its position, and how it reads tokens. */
#ifndef ISOC_SCENE_TAKE_H
#define ISOC_SCENE_TAKE_H

#include "tools/isoc/base/dictionary.h"
#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/scene.h"

struct block;

enum { LONGEST_NAME = 64, MOST_PROPERTIES = 32 };

/* A repeat that is being read, in another one or in none. */
typedef struct repetition {
    name index;
    int value;
    const struct repetition *outer;
} repetition;

/* A file that is being read, included by another one or by none. */
typedef struct inclusion {
    const script *of;
    const struct inclusion *outer;
} inclusion;

typedef struct parser {
    source *s;
    scene *made;
    const token *next;
    bool failed;   /* in this statement or property */
    int depth;     /* of nested parentheses */
    name *factors; /* units after * or /, where a parameter's name could stand */
    size_t factor_count, factor_room;
    const struct block *statements, *within; /* the words of the scene, and of the block that is being read */
    const token *first[MOST_PROPERTIES];     /* where each statement stands first, in all files */
    const repetition *repeated;
    const inclusion *included;
    int nested;   /* repeats and includes around this */
    size_t words; /* of all readings so far */
    bool is_full; /* there were too many */
    name *indices;
    size_t index_count, index_room;
    dictionary known; /* constants that are plain numbers */
    double *numbers;  /* theirs */
    size_t number_count, number_room;
} parser;

/* Notes a problem at the next token, once a statement, and sets p->failed. */
void parse_problem(parser *p, const char *message);

/* Notes a problem at a place, as source_problem, and sets p->failed. Returns false. */
#define PARSE_FAULT(p, ...) ((p)->failed = true, source_problem((p)->s, __VA_ARGS__))

bool next_is_sign(const parser *p, char sign);
bool next_is_word(const parser *p, const char *word);

/* Takes the next token if it is this sign or this word. After a problem nothing is taken in this statement. */
bool take_sign(parser *p, char sign);
bool take_word(parser *p, const char *word);

/* The same of one that must be there; else notes what is expected. */
void expect_sign(parser *p, char sign, const char *expected);
void expect_word(parser *p, const char *word, const char *expected);

/* The same of a word that a statement may go on with where it is complete: not across the end of a line. */
bool take_option(parser *p, const char *word);

/* The index of the next token among words, which is taken; or count, with a problem that lists them. */
size_t take_one_of(parser *p, const char *const *words, size_t count);

/* A name with its indices, which must be on the same line. A new name must not be a word of the language; a parameter's must not be a
 * common unit. */
name take_name(parser *p, const char *expected);
name take_new_name(parser *p, const char *expected);
name take_parameter_name(parser *p, const char *expected);

/* A new name within an effect, where few words stand for something. */
name take_inner_name(parser *p, const char *expected);

#endif
