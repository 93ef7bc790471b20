#include "tools/isoc/scene/source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/isoc/base/nearest.h"

enum {
    LARGEST_FILE = 64 << 20, /* bytes; a scene is some kilobytes */
    PROBLEMS_SHOWN = 20,
    COLUMNS_SHOWN = 100, /* of a long line, around the caret */
};

const char *source_name(const source *s)
{
    const char *base = strrchr(s->path, '/') == NULL ? s->path : strrchr(s->path, '/') + 1;
    const size_t length = strcspn(base, ".");
    char *made = length == 0 ? arena_copy(s->memory, "scene", 5) : arena_copy(s->memory, base, length);
    for (char *c = made; *c != '\0'; c++) {
        const bool letter = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9');
        *c = letter ? *c : '_';
    }
    return made;
}

/* Why this file cannot be a scene; NULL if it can. */
static const char *file_fault(const struct stat *status)
{
    return S_ISDIR(status->st_mode)         ? "a directory, not a scene: name a .scene file in it"
           : !S_ISREG(status->st_mode)      ? "not a regular file: a scene is a text file"
           : status->st_size > LARGEST_FILE ? "larger than 64 MiB: not a scene"
                                            : NULL;
}

/* All bytes of an open file, or what is wrong with it. */
static const char *read_all(source *s, int file)
{
    struct stat status;
    if (fstat(file, &status) != 0) {
        return strerror(errno);
    }
    const char *fault = file_fault(&status);
    if (fault != NULL) {
        return fault;
    }
    char *bytes = arena_take(s->memory, (size_t)status.st_size + 1, 1);
    ssize_t got = 1;
    while (s->length < (size_t)status.st_size && got > 0) {
        got = read(file, bytes + s->length, (size_t)status.st_size - s->length);
        s->length += got > 0 ? (size_t)got : 0;
    }
    s->text = bytes;
    return got < 0 ? strerror(errno) : NULL;
}

bool source_read(source *s, arena *memory, const char *path)
{
    *s = (source){.memory = memory, .path = path};
    const int file = open(path, O_RDONLY | O_NONBLOCK); /* which does not wait for the other end of a FIFO */
    const char *fault = file < 0 ? strerror(errno) : read_all(s, file);
    if (fault != NULL) {
        fprintf(stderr, "%s: error: %s\n", path, fault);
    }
    if (file >= 0) {
        close(file);
    }
    return fault == NULL;
}

void source_problem(source *s, place at, const char *format, ...)
{
    char message[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    if (s->used_by != NULL) {
        const size_t length = strlen(message);
        snprintf(message + length, sizeof message - length, "; %s", s->used_by);
    }

    s->problems = arena_grow(s->memory, s->problems, s->problem_count, &s->problem_room, sizeof *s->problems);
    s->problems[s->problem_count++] = (problem){at, arena_copy(s->memory, message, strlen(message))};
}

static place line_start(const source *s, place at)
{
    while (at > 0 && s->text[at - 1] != '\n') {
        at--;
    }
    return at;
}

size_t source_line(const source *s, place at)
{
    size_t line = 1;
    for (place i = 0; i < at; i++) {
        line += s->text[i] == '\n';
    }
    return line;
}

const char *source_quote(const source *s, place at)
{
    enum { MOST = 100 };
    const char *from = s->text + line_start(s, at);
    from += strspn(from, " \t");
    size_t length = strcspn(from, "#\r\n");
    while (length > 0 && strchr(" \t{", from[length - 1]) != NULL) {
        length--;
    }
    const char *more = length > MOST ? " ..." : "";
    char *words = arena_format(s->memory, "%.*s%s", (int)(length > MOST ? MOST : length), from, more);
    for (char *c = words; *c != '\0'; c++) {
        const bool ends_comment = (c[0] == '*' && c[1] == '/') || (c[0] == '/' && c[1] == '*');
        *c = ends_comment || *c == '\\' || *c == '?' || (unsigned char)*c < ' ' ? ' ' : *c;
    }
    return words;
}

static bool starts_character(char c)
{
    return ((unsigned char)c & 0xC0) != 0x80; /* not a continuation byte of UTF-8 */
}

/* The characters from `from` to `to`, each as one column: control characters as spaces. */
static size_t print_part(const source *s, place from, place to, bool visible)
{
    size_t columns = 0;
    for (place i = from; i < to; i++) {
        columns += starts_character(s->text[i]);
        if (visible) {
            unsigned char c = (unsigned char)s->text[i];
            fputc(c < ' ' || c == 0x7F ? ' ' : c, stderr);
        }
    }
    return columns;
}

static void report_one(const source *s, const problem *p)
{
    const place start = line_start(s, p->at);
    place end = p->at;
    while (end < s->length && s->text[end] != '\n' && s->text[end] != '\r') {
        end++;
    }
    fprintf(stderr, "%s:%zu:%zu: error: %s\n", s->path, source_line(s, p->at), 1 + print_part(s, start, p->at, false),
            p->message);

    /* Of a very long line, only what stands near the caret; both cuts at the start of a character. */
    place from = p->at - start > COLUMNS_SHOWN ? p->at - COLUMNS_SHOWN : start;
    while (from < p->at && !starts_character(s->text[from])) {
        from++;
    }
    place to = end - p->at > COLUMNS_SHOWN ? p->at + COLUMNS_SHOWN : end;
    while (to < end && !starts_character(s->text[to])) {
        to++;
    }
    fputs("    ", stderr);
    const size_t before = print_part(s, from, p->at, true);
    print_part(s, p->at, to, true);
    fprintf(stderr, "\n    %*s^\n", (int)before, "");
}

static int by_place(const void *left, const void *right)
{
    const problem *a = left, *b = right;
    if (a->at != b->at) {
        return a->at < b->at ? -1 : 1;
    }
    return strcmp(a->message, b->message);
}

void source_report(source *s)
{
    if (s->problem_count == 0) {
        return;
    }
    qsort(s->problems, s->problem_count, sizeof *s->problems, by_place);
    size_t shown = 0;
    for (size_t i = 0; i < s->problem_count && shown < PROBLEMS_SHOWN; i++) {
        if (i == 0 || by_place(&s->problems[i - 1], &s->problems[i]) != 0) {
            report_one(s, &s->problems[i]);
            shown++;
        }
    }
    if (s->problem_count > shown && shown == PROBLEMS_SHOWN) {
        fprintf(stderr, "%s: %zu more errors\n", s->path, s->problem_count - shown);
    }
}

const char *source_suggestion(source *s, const char *typed, const char *const *names, size_t count)
{
    const char *name = nearest(typed, names, count);
    return name == NULL ? "" : arena_format(s->memory, " (did you mean '%s'?)", name);
}
