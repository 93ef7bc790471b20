/* Problems of a scene: noted as they are found, then printed in the order of the text. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/isoc/base/nearest.h"
#include "tools/isoc/scene/source.h"

enum {
    PROBLEMS_SHOWN = 20,
    COLUMNS_SHOWN = 100, /* of a long line, around the caret */
};

/* A problem with the byte of the text that it is at. */
typedef struct located {
    const script *origin;
    size_t offset, first; /* first: the place of the problem */
    const char *message, *note;
    size_t again; /* in how many further repetitions it is the same */
} located;

bool source_problem(source *s, place at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const char *message = arena_format_list(s->memory, format, arguments);
    va_end(arguments);
    if (s->used_by != NULL) {
        message = arena_format(s->memory, "%s; in the effect '%s', %s", message, s->used_by->text,
                               source_line(s, s->used_by->at));
    }
    ADD_TO(s->memory, s->problems, s->problem_count, s->problem_room, ((problem){at, message}));
    return false;
}

static bool starts_character(char c)
{
    return ((unsigned char)c & 0xC0) != 0x80; /* not a continuation byte of UTF-8 */
}

/* The characters from `from` to `to`, each as one column: control characters as spaces. */
static size_t print_part(const script *s, size_t from, size_t to, bool visible)
{
    size_t columns = 0;
    for (size_t i = from; i < to; i++) {
        columns += starts_character(s->text[i]);
        if (visible) {
            unsigned char c = (unsigned char)s->text[i];
            fputc(c < ' ' || c == 0x7F ? ' ' : c, stderr);
        }
    }
    return columns;
}

/* (i = 3, and 2 more) */
static void print_note(const located *p)
{
    if (p->note != NULL && p->again > 0) {
        fprintf(stderr, " (%s, and %zu more)", p->note, p->again);
    } else if (p->note != NULL) {
        fprintf(stderr, " (%s)", p->note);
    }
}

static void report_one(const located *p, const char *kind)
{
    const char *text = p->origin->text;
    size_t start = p->offset, line = 1;
    while (start > 0 && text[start - 1] != '\n') {
        start--;
    }
    size_t end = p->offset;
    while (end < p->origin->length && text[end] != '\n' && text[end] != '\r') {
        end++;
    }
    for (size_t i = 0; i < start; i++) {
        line += text[i] == '\n';
    }
    fprintf(stderr, "%s:%zu:%zu: %s: %s", p->origin->path, line, 1 + print_part(p->origin, start, p->offset, false),
            kind, p->message);
    print_note(p);

    /* Of a very long line, only the part near the caret; both cuts are at the start of a character. */
    size_t from = p->offset - start > COLUMNS_SHOWN ? p->offset - COLUMNS_SHOWN : start;
    while (from < p->offset && !starts_character(text[from])) {
        from++;
    }
    size_t to = end - p->offset > COLUMNS_SHOWN ? p->offset + COLUMNS_SHOWN : end;
    while (to < end && !starts_character(text[to])) {
        to++;
    }
    fputs("\n    ", stderr);
    const size_t before = print_part(p->origin, from, p->offset, true);
    print_part(p->origin, p->offset, to, true);
    fprintf(stderr, "\n    %*s^\n", (int)before, "");
}

/* The order of two texts without their numbers, in which those of two repetitions differ: s[1] is s1. */
static int by_text_but_numbers(const char *a, const char *b)
{
    static const char digits[] = "0123456789";
    for (a += strspn(a, digits), b += strspn(b, digits); *a == *b && *a != '\0';) {
        a += 1 + strspn(a + 1, digits);
        b += 1 + strspn(b + 1, digits);
    }
    return (unsigned char)*a - (unsigned char)*b;
}

static int by_place_and_text(const located *a, const located *b)
{
    if (a->origin != b->origin) {
        return a->origin->order < b->origin->order ? -1 : 1;
    }
    return a->offset != b->offset ? (a->offset < b->offset ? -1 : 1) : by_text_but_numbers(a->message, b->message);
}

static int by_text_and_reading(const void *left, const void *right)
{
    const located *a = left, *b = right;
    const int order = by_place_and_text(a, b);
    return order != 0 ? order : a->first != b->first ? (a->first < b->first ? -1 : 1) : strcmp(a->message, b->message);
}

static located locate_one(const source *s, const problem *p)
{
    const passage *in = source_find(s, p->at);
    return (located){in->origin, in->offset + (p->at - in->from), p->at, p->message, in->note, 0};
}

/* The problems in the order of the text, each once, also if it is one of several repetitions: returns their number. */
static size_t locate(const source *s, located *all)
{
    for (size_t i = 0; i < s->problem_count; i++) {
        all[i] = locate_one(s, &s->problems[i]);
    }
    qsort(all, s->problem_count, sizeof *all, by_text_and_reading);
    size_t kept = 0;
    for (size_t i = 0; i < s->problem_count; i++) {
        located *last = kept == 0 ? NULL : &all[kept - 1];
        const bool is_new = last == NULL || by_place_and_text(last, &all[i]) != 0;
        if (is_new || (last->first == all[i].first && strcmp(last->message, all[i].message) != 0)) {
            all[kept++] = all[i];
        } else if (last->first != all[i].first) {
            last->again++;
            last->first = all[i].first;
        }
    }
    return kept;
}

bool source_report(source *s)
{
    located *all = arena_take(s->memory, s->problem_count + 1, sizeof *all);
    const size_t count = s->problem_count == 0 ? 0 : locate(s, all);
    for (size_t i = 0; i < count && i < PROBLEMS_SHOWN; i++) {
        report_one(&all[i], "error");
    }
    if (count > PROBLEMS_SHOWN) {
        fprintf(stderr, "%s: %zu more errors\n", s->path, count - PROBLEMS_SHOWN);
    }
    return false;
}

void source_warn(const source *s, place at, const char *format, ...)
{
    if (s->is_silent) {
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    const char *message = arena_format_list(s->memory, format, arguments);
    va_end(arguments);
    const located found = locate_one(s, &(problem){at, message});
    report_one(&found, "warning");
}

const char *source_suggestion(source *s, const char *typed, const char *const *names, size_t count)
{
    const char *found = nearest(typed, names, count);
    return found == NULL ? "" : arena_format(s->memory, " (did you mean '%s'?)", found);
}
