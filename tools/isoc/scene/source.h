/* The text of a scene, and its problems.
 *
 * A scene is read from its file and those that it includes, and a repeated part of it several times. Each reading is a
 * passage of places of its own, so that one number says which line of which file it is, and in which repetition.
 */
#ifndef ISOC_SCENE_SOURCE_H
#define ISOC_SCENE_SOURCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tools/isoc/base/arena.h"

/* A byte of a reading: its offset from the beginning of the first one. */
typedef size_t place;

/* A name as used or declared. */
typedef struct name {
    const char *text; /* NULL when it is absent */
    place at;
} name;

typedef struct script {
    const char *path;
    const char *text; /* ended by a zero that is not part of it */
    size_t length;
    uint64_t device, number; /* of the file, by which it is known again under another path */
    size_t order;            /* of the first reading */
} script;

typedef struct passage {
    place from;
    const script *origin;
    size_t offset;    /* of `from` in the script */
    const char *note; /* i = 3; NULL: outside of all repetitions */
} passage;

typedef struct problem {
    place at;
    const char *message;
} problem;

typedef struct source {
    arena *memory;
    const char *path; /* of the scene */
    const script **scripts;
    passage *passages;
    problem *problems;
    const char **paths; /* of all files that were asked for */
    size_t script_count, script_room, passage_count, passage_room, problem_count, problem_room, path_count, path_room;
    place end;           /* of the last passage */
    bool is_silent;      /* no warning is printed */
    const name *used_by; /* of the use of an effect for which problems are noted, besides their place; or NULL */
} source;

/* Reads a file whole. Returns false after saying on stderr why it could not. */
bool source_read(source *s, arena *memory, const char *path);

/* A further file, read once; NULL with the reason in *fault if it cannot be. */
const script *source_open(source *s, const char *path, const char **fault);

/* A further script with this text. */
const script *source_add(source *s, const char *path, const char *text);

/* The places of a reading of `length` bytes of a script from this offset on: returns the first. */
place source_passage(source *s, const script *origin, size_t offset, size_t length, const char *note);

/* The reading that a place belongs to. */
const passage *source_find(const source *s, place at);

/* The name of the scene: its file's name without folder and ending, as an identifier. */
const char *source_name(const source *s);

/* "line 3", "line 3 of legs.scene", "line 3 (i = 2)". */
const char *source_line(const source *s, place at);

/* Prints a warning: the scene compiles, but hardly as its author means. In the form path:line:column: warning: message.
 */
void source_warn(const source *s, place at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The line of a place, without indentation, comment and opening brace, as words for a comment in C. */
const char *source_quote(const source *s, place at);

/* The comment at the end of the line of a place; "" where it has none. */
const char *source_comment(const source *s, place at);

/* Notes a problem at a place; compilation goes on to find more. Returns false. */
bool source_problem(source *s, place at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Prints the problems on stderr in the order of files and lines as path:line:column: error: message, each with its line
 * and a caret; a problem of every repetition only once. Returns false. */
bool source_report(source *s);

/* The nearest of `count` names to a mistyped one, as " (did you mean 'x'?)", or "" when none is near. */
const char *source_suggestion(source *s, const char *typed, const char *const *names, size_t count);

#endif
