#include "tools/sweep/plan.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void plan_fail(const char *const what, const char *const which)
{
    fprintf(stderr, "sweep: %s: %s\n", which, what);
    exit(EXIT_FAILURE);
}

/* A file whole, with a final zero. */
static char *read_whole(const char *const path)
{
    FILE *const from = fopen(path, "rb");
    size_t length = 0, room = 1 << 16;
    char *text = malloc(room);
    if (from == NULL || text == NULL) {
        plan_fail(strerror(errno), path);
    }
    for (size_t got; (got = fread(text + length, 1, room - length - 1, from)) > 0;) {
        length += got;
        if (length + 1 == room) {
            room *= 2;
            text = realloc(text, room);
            if (text == NULL) {
                plan_fail(strerror(errno), path);
            }
        }
    }
    if (ferror(from) != 0) {
        plan_fail(strerror(errno), path);
    }
    fclose(from);
    text[length] = '\0';
    return text;
}

/* What is read next. */
typedef struct reader {
    char *next;
    const char *path;
} reader;

static char *read_line(reader *const r)
{
    char *const line = r->next, *const end = strchr(line, '\n');
    if (end == NULL) {
        plan_fail("the plan is not whole", r->path);
    }
    *end = '\0';
    r->next = end + 1;
    return line;
}

static uint64_t read_count(reader *const r, const char *const word)
{
    const char *const line = read_line(r);
    const size_t length = strlen(word);
    char *end = NULL;
    if (strncmp(line, word, length) != 0 || line[length] != ' ') {
        plan_fail("it is no plan of a sweep", r->path);
    }
    const uint64_t count = strtoull(line + length + 1, &end, 10);
    if (*end != '\0' || count > 10000000) {
        plan_fail("it is no plan of a sweep", r->path);
    }
    return count;
}

/* The cells of a line that has `count` of them, separated by tabs. */
static void split(const reader *const r, char *line, const char **const cells, const int count)
{
    for (int i = 0; i < count; i++) {
        cells[i] = line;
        char *const end = line == NULL ? NULL : strchr(line, '\t');
        if ((end == NULL) != (i + 1 == count)) {
            plan_fail("a line of the plan has other cells", r->path);
        }
        line = end == NULL ? NULL : end + 1;
        if (end != NULL) {
            *end = '\0';
        }
    }
}

static void *room_for(const uint64_t count, const size_t bytes)
{
    void *const made = calloc((size_t)count + 1, bytes);
    if (made == NULL) {
        plan_fail(strerror(errno), "memory");
    }
    return made;
}

plan plan_read(const char *const folder)
{
    static char path[PLAN_PATH_BYTES];
    plan p = {.folder = folder};
    plan_path(&p, "plan", path, sizeof path);
    reader r = {read_whole(path), path};
    const char *cells[4];
    if (read_count(&r, "sweep") != 1) {
        plan_fail("another version of this program wrote the plan", path);
    }
    p.runs = read_count(&r, "runs");
    p.parts = read_count(&r, "parts");
    p.plants = read_count(&r, "plants");
    p.variable_count = read_count(&r, "variables");
    p.variables = room_for(p.variable_count, sizeof *p.variables);
    for (uint64_t i = 0; i < p.variable_count; i++) {
        split(&r, read_line(&r), cells, 4);
        p.variables[i] = (plan_variable){cells[0], cells[1], cells[2], atoi(cells[3])};
    }
    p.column_count = read_count(&r, "columns");
    p.columns = room_for(p.column_count, sizeof *p.columns);
    for (uint64_t i = 0; i < p.column_count; i++) {
        split(&r, read_line(&r), cells, 4);
        p.columns[i] = (plan_column){cells[0], cells[1], cells[2], atoi(cells[3])};
    }
    p.output_count = read_count(&r, "outputs");
    p.outputs = read_line(&r);
    p.lines = room_for(p.runs, sizeof *p.lines);
    for (uint64_t i = 0; i < p.runs; i++) {
        p.lines[i] = read_line(&r);
    }
    if (p.parts == 0 || p.parts > p.runs) {
        plan_fail("it is no plan of a sweep", path);
    }
    return p;
}

uint64_t plan_first(const plan *const p, const uint64_t part)
{
    return part * p->runs / p->parts;
}

/* Copies a cell, and returns what is behind it. */
static const char *take_cell(const plan *const p, const char *const from, char *const to, const size_t room)
{
    const size_t length = strcspn(from, "\t");
    if (length == 0 || length >= room) {
        plan_fail("a run of the plan has other cells", p->folder);
    }
    memcpy(to, from, length);
    to[length] = '\0';
    return from + length + (from[length] == '\t');
}

uint64_t plan_cells(const plan *const p, const uint64_t run, plan_cell *const cells)
{
    char plant[32];
    const char *next = take_cell(p, p->lines[run], plant, sizeof plant);
    for (uint64_t i = 0; i < p->variable_count; i++) {
        next = take_cell(p, next, cells[i].text, sizeof cells[i].text);
        cells[i].literal[0] = '\0';
        if (p->variables[i].tunable >= 0) {
            next = take_cell(p, next, cells[i].literal, sizeof cells[i].literal);
        }
    }
    const uint64_t which = strtoull(plant, NULL, 10);
    if (which >= p->plants) {
        plan_fail("a run of the plan is of no plant", p->folder);
    }
    return which;
}

void plan_path(const plan *const p, const char *const what, char *const path, const unsigned bytes)
{
    const int length = snprintf(path, bytes, "%s/%s", p->folder, what);
    if (length < 0 || (unsigned)length >= bytes) {
        plan_fail("the path is too long", p->folder);
    }
}

void plan_part_path(const plan *const p, const uint64_t part, char *const path, const unsigned bytes)
{
    char name[48];
    snprintf(name, sizeof name, "parts/%" PRIu64 ".tsv", part);
    plan_path(p, name, path, bytes);
}

bool plan_has_part(const plan *const p, const uint64_t part)
{
    char path[PLAN_PATH_BYTES];
    plan_part_path(p, part, path, sizeof path);
    return access(path, F_OK) == 0;
}
