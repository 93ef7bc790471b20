/* The text of a scene, and what is wrong with it. */
#ifndef ISOC_SCENE_SOURCE_H
#define ISOC_SCENE_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/isoc/base/arena.h"

/* A place in the text: a byte offset. */
typedef size_t place;

typedef struct problem {
    place at;
    const char *message;
} problem;

typedef struct source {
    arena *memory;
    const char *path;
    const char *text; /* ended by a zero that is not part of it */
    size_t length;
    problem *problems;
    size_t problem_count, problem_room;
    const char *used_by; /* what problems are of, besides their place: the use of an effect; or NULL */
} source;

/* What the scene is called: its file's name without folder and ending, as an identifier. */
const char *source_name(const source *s);

/* Reads a file whole. Returns false after saying on stderr why it could not. */
bool source_read(source *s, arena *memory, const char *path);

/* Notes a problem at a place; compilation goes on to find more. */
void source_problem(source *s, place at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Prints the problems on stderr in file order as path:line:column: error: message, each with its line and a caret. */
void source_report(source *s);

/* The line number (from 1) of a place. */
size_t source_line(const source *s, place at);

/* The line of a place, without indentation, comment and opening brace, as words for a comment in C. */
const char *source_quote(const source *s, place at);

/* The nearest of `count` names to a mistyped one, as " (did you mean 'x'?)", or "" when none is near. */
const char *source_suggestion(source *s, const char *typed, const char *const *names, size_t count);

#endif
