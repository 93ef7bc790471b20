/* Shared by all parts of the parser: its position, and how it reads tokens. */
#ifndef ISOC_SCENE_TAKE_H
#define ISOC_SCENE_TAKE_H

#include "tools/isoc/base/dictionary.h"
#include "tools/isoc/base/text.h"
#include "tools/isoc/scene/lexer.h"
#include "tools/isoc/scene/scene.h"

struct block;

enum { LONGEST_NAME = 64, MOST_PROPERTIES = 48 };

/* A repeat that is being read, in another one or in none. */
typedef struct repetition {
    name index;
    int value;
    const struct repetition *outer;
} repetition;

/* A file that is being read, included by another one or by none. */
typedef struct inclusion {
    const script *file;
    const struct inclusion *outer;
} inclusion;

typedef struct parser {
    source *s;
    scene *target;
    const token *next, *word;                /* word: that of the statement or property */
    bool failed;                             /* in this statement or property */
    int depth;                               /* of nested parentheses */
    LIST_OF(name) factors;                   /* units after * or /, where a parameter's name could stand */
    const struct block *statements, *within; /* the words of the scene, and of the block that is being read */
    const token *first[MOST_PROPERTIES];     /* where each statement stands first, in all files */
    const repetition *repeated;
    const inclusion *included;
    const rate_block *block; /* of a rate, that is being read; NULL: none */
    int nested;              /* repeats and includes around this */
    size_t words;            /* of all readings so far */
    bool is_full;            /* there were too many */
    LIST_OF(name) indices;
    dictionary known;        /* constants that are plain numbers */
    LIST_OF(double) numbers; /* theirs */
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

/* The same of a sign that must be there; else notes `expected`. */
void expect_sign(parser *p, char sign, const char *expected);
void expect_word(parser *p, const char *word, const char *expected);

/* The same of a word that a statement may go on with where it is complete: not across the end of a line. */
bool take_option(parser *p, const char *word);

/* The index of the next token among words, which is taken; or count, with a problem that lists them. */
size_t take_one_of(parser *p, const char *const *words, size_t count);

/* A name with its indices, which must be on the same line. A new name must not be a word of the language; a parameter's
 * must not be a common unit. */
name take_name(parser *p, const char *expected);
name take_new_name(parser *p, const char *expected);
name take_parameter_name(parser *p, const char *expected);

/* A new name within an effect, where few words have a meaning. */
name take_inner_name(parser *p, const char *expected);

/* PERIOD [at PHASE], behind the word that begins a block of a rate; NULL after noting a problem. */
const rate_block *take_rate(parser *p);

/* The names of the values of a mode, from 0 on. */
typedef LIST_OF(name) name_choices;

/* block.c: blocks: words, each with its value, in any order, each at most once; { mass 1 kg; com (0, 0, 1) m }. A
 * scene is one too, without braces. One table for each has its words, and the kinds of joints or closures that have
 * them. */

/* Reads the value that follows the word into its slot. */
typedef void property_reader(parser *p, void *slot);

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

/* Members of a block: the rows of its kinds, and its properties. */
#define KINDS(rows) .kinds = rows, .kind_size = sizeof(rows)[0], .kind_count = COUNT_OF(rows)
#define PROPERTIES(table) .properties = table, .property_count = COUNT_OF(table)

/* The kind, which follows the name. An unknown one is noted as a problem; then the result is kind_count, which has all
 * properties and needs none. */
size_t parse_kind(parser *p, const block *b);

/* { property ... } of a thing called `whose`, into the struct `to`. Returns whether all could be read and nothing is
 * missing. */
bool parse_block(parser *p, const block *b, size_t kind, name whose, void *to);

/* One statement after the other, to the end. Returns whether all could be read. */
bool parse_statements(parser *p, const block *statements, void *to);

/* The same of statements, or of the lines of a block whose words may come more than once. */
bool parse_items_of(parser *p, const block *b, void *to);

/* A parser of the text of an option, into the scene; `read` has the text that is read in its place. */
parser parser_of_option(source *s, scene *target, const script *original, const script *read);

/* Reads items with ; between them, to the end or to a problem; `further` is that of another sign. */
typedef void item_reader(parser *p, void *to);
void parse_items(parser *p, item_reader *read, void *to, const char *further);

/* The property of b with this word, for any kind; property_count: none. And whether there is one. */
size_t block_index(const block *b, const token *t);
bool block_has_word(const block *b, const token *t);

/* NUMBER ticks: the number; NULL after noting `expected`, or another problem. */
formula *parse_ticks(parser *p, const char *expected);

/* Readers of properties that many blocks have; their slots are a formula *, a name, or of yes and no a bool. */
property_reader read_formula, read_axis, read_input, read_joint, read_method, read_switch;

/* parse_formula.c: tokens to formulas. */

/* One formula: sums of products of signed powers of numbers with units, names, vectors and calls. Returns NULL, with
 * p->failed set and a problem noted, where there is none, or where one is noted already. */
formula *parse_formula(parser *p);

/* A number that stands in no text of its own. */
formula *formula_of_number(parser *p, double number, place at);

/* A comparison, or several with `and`, `or` and `not`; or any other formula. */
formula *parse_condition(parser *p);

/* A new formula; and one more part of it. */
formula *formula_new(parser *p, formula_kind kind, place at);
void formula_put(parser *p, formula *f, formula *part);

/* parse_table.c: what stands in a table behind the quantities that it is of. Each of the first two returns whether it
 * stands there: smooth, or beyond linear; a file of points, "map.csv" [column 3]. The lines of values of two. */
bool take_table_option(parser *p, formula *f);
bool take_map(parser *p, formula *f);
void parse_grid(parser *p, formula *f);

/* x, y, z, -x, -y, -z or a vector. */
formula *parse_axis(parser *p);

/* Whether `of` follows the next word on its line. */
bool next_is_owned(const parser *p);

/* Whether the next words are those of a quantity: speed of NAME. */
bool next_is_quantity(const parser *p);

/* Takes a unit, such as N*m/A, where the next token begins one. Returns whether it does. */
bool take_unit(parser *p, unit *taken);

/* 2 N * ks: a unit, though a quantity has this name too. Notes it at the name, for the factors from this one on. */
void refuse_factor(parser *p, size_t from, name called);

/* repeat.c: indices of repeats, and their names. */

/* The index of a repeat that is being read; NULL if none has this name. */
const int *find_index(const parser *p, const char *called);

/* { [ index ] } after a name: leg[3] is leg3, and wheel2[3] is wheel2_3. Returns the whole name. */
const char *take_indices(parser *p, const char *called);

/* A file that the file of this place names: relative to its folder. NULL with the reason in *fault. */
const script *open_beside(parser *p, place word, const char *named, const char **fault);

/* Reads these tokens as statements, or as lines of the block that is being read. */
void parse_nested(parser *p, const token *tokens, void *to);

/* A constant that is a plain number can be used in indices below it. */
void note_constant(parser *p, const quantity *q);

/* An index and a parameter must not have one name. */
void check_indices(const parser *p);

/* pose.c: a pose: a place, then turns one after the other. */

/* [at FORMULA] ({ rotate FORMULA [about AXIS] } | quaternion FORMULA), or as much of it as there is. If axis_needed,
 * each turn must have its axis; if part_needed, the first part may stand on the next line. */
pose parse_pose(parser *p, bool axis_needed, bool part_needed);

/* [at FORMULA] { rotate FORMULA about AXIS } of `what`, on no body. */
placement parse_place_and_turns(parser *p, const char *what);

/* A body, and a place and turns on it; the slot is a placement. */
property_reader read_placement;

/* parse_event.c: modes and events, of an effect and of the scene. */

/* { set TARGET = VALUE; ... } */
void parse_sets(parser *p, when_statement *to);

/* NAME on JOINT up to LIMIT [then SLIDING], or NAME between JOINT and JOINT up to ... */
void parse_hold(parser *p, hold_statement *to);

/* [in (NAME, ...)] = START, behind the name of a mode. */
void parse_mode(parser *p, quantity *to, name_choices *choices);

/* Statements that have a file of their own; the slot of each reader is the scene, of `stabilisation` and of how the
 * loop runs that of a scene. `repeat` and `include` add the statements in them. */

property_reader read_body, read_frame, read_joint_statement, read_closure, read_force, read_spring_statement,
    read_stabilisation, read_output, read_effect, read_signal, read_mode, read_when, read_hold, read_events,
    read_setting, read_rate_block, read_repeat, read_include, read_overrun, read_grace, read_publish, read_histogram;

#endif
