#include "tools/isoc/scene/source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LARGEST_FILE = 64 << 20 }; /* bytes; a scene is some kilobytes */

const char *source_name(const source *s)
{
    const char *base = strrchr(s->path, '/') == NULL ? s->path : strrchr(s->path, '/') + 1;
    const size_t length = strcspn(base, ".");
    char *result = length == 0 ? arena_copy(s->memory, "scene", 5) : arena_copy(s->memory, base, length);
    for (char *c = result; *c != '\0'; c++) {
        const bool letter = (*c >= 'a' && *c <= 'z') || (*c >= 'A' && *c <= 'Z') || (*c >= '0' && *c <= '9');
        *c = letter ? *c : '_';
    }
    return result;
}

/* Why this file cannot be a scene; NULL if it can. */
static const char *file_fault(const struct stat *status)
{
    return S_ISDIR(status->st_mode)         ? "a directory, not a scene: name a .scene file in it"
           : !S_ISREG(status->st_mode)      ? "not a regular file: a scene is a text file"
           : status->st_size > LARGEST_FILE ? "larger than 64 MiB: not a scene"
                                            : NULL;
}

/* Reads all bytes of an open file into `result`, or returns the problem as text. */
static const char *read_all(arena *memory, int file, script *result)
{
    struct stat status;
    if (fstat(file, &status) != 0) {
        return strerror(errno);
    }
    const char *fault = file_fault(&status);
    if (fault != NULL) {
        return fault;
    }
    result->device = (uint64_t)status.st_dev;
    result->number = (uint64_t)status.st_ino;
    char *bytes = arena_take(memory, (size_t)status.st_size + 1, 1);
    ssize_t got = 1;
    while (result->length < (size_t)status.st_size && got > 0) {
        got = read(file, bytes + result->length, (size_t)status.st_size - result->length);
        result->length += got > 0 ? (size_t)got : 0;
    }
    result->text = bytes;
    return got < 0 ? strerror(errno) : NULL;
}

static const script *keep(source *s, script read)
{
    script *result = arena_take(s->memory, 1, sizeof *result);
    *result = read;
    result->order = s->script_count;
    ADD_TO(s->memory, s->scripts, s->script_count, s->script_room, result);
    return result;
}

const script *source_open(source *s, const char *path, const char **fault)
{
    script read = {.path = path};
    ADD_TO(s->memory, s->paths, s->path_count, s->path_room, path);
    const int file = open(path, O_RDONLY | O_NONBLOCK); /* which does not wait for the other end of a FIFO */
    *fault = file < 0 ? strerror(errno) : read_all(s->memory, file, &read);
    if (file >= 0) {
        close(file);
    }
    for (size_t i = 0; i < s->script_count && *fault == NULL; i++) {
        if (s->scripts[i]->device == read.device && s->scripts[i]->number == read.number) {
            return s->scripts[i];
        }
    }
    return *fault == NULL ? keep(s, read) : NULL;
}

const script *source_add(source *s, const char *path, const char *text)
{
    return keep(s, (script){.path = path, .text = text, .length = strlen(text)});
}

bool source_read(source *s, arena *memory, const char *path)
{
    const char *fault;
    *s = (source){.memory = memory, .path = path};
    const script *main_script = source_open(s, path, &fault);
    if (main_script == NULL) {
        fprintf(stderr, "%s: error: %s\n", path, fault);
        return false;
    }
    source_passage(s, main_script, 0, main_script->length, NULL);
    return true;
}

place source_passage(source *s, const script *origin, size_t offset, size_t length, const char *note)
{
    const place from = s->end;
    ADD_TO(s->memory, s->passages, s->passage_count, s->passage_room, ((passage){from, origin, offset, note}));
    s->end += length + 1; /* with a place for its end */
    return from;
}

/* The last one that begins at the place or before. */
const passage *source_find(const source *s, place at)
{
    size_t low = 0, high = s->passage_count;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        *(s->passages[middle].from <= at ? &low : &high) = middle;
    }
    return &s->passages[low];
}

const char *source_line(const source *s, place at)
{
    const passage *in = source_find(s, at);
    const size_t offset = in->offset + (at - in->from);
    size_t line = 1;
    for (size_t i = 0; i < offset; i++) {
        line += in->origin->text[i] == '\n';
    }
    const char *of_file = in->origin == s->scripts[0] ? "" : arena_format(s->memory, " of %s", in->origin->path);
    const char *note = in->note == NULL ? "" : arena_format(s->memory, " (%s)", in->note);
    return arena_format(s->memory, "line %zu%s%s", line, of_file, note);
}

/* The line of a place, behind its indentation. */
static const char *line_of(const source *s, place at)
{
    const passage *in = source_find(s, at);
    size_t start = in->offset + (at - in->from);
    while (start > 0 && in->origin->text[start - 1] != '\n') {
        start--;
    }
    const char *line = in->origin->text + start;
    return line + strspn(line, " \t");
}

const char *source_comment(const source *s, place at)
{
    const char *line = line_of(s, at), *comment = line + strcspn(line, "#\r\n");
    comment += strspn(comment, "# ");
    return arena_copy(s->memory, comment, strcspn(comment, "\r\n"));
}

const char *source_quote(const source *s, place at)
{
    enum { MOST = 100 };
    const char *from = line_of(s, at);
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
