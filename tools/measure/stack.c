/* The deepest stack of a function and of all that it calls, in bytes, from gcc's -fcallgraph-info=su.
 *
 *     stack FUNCTION <plant.ci
 *
 * Prints the path with the frame of each function. Status 1 if there is no bound: recursion, a call through a pointer, a frame
 * that grows at run time, or a function whose frame is not in the file.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/table/table.h"

typedef struct function {
    const char *name;
    long frame, deepest; /* bytes; frame -1: not known, deepest -1: not visited */
    size_t next;         /* where it goes deepest; its own number: nowhere */
    bool grows, active;
} function;

typedef struct graph {
    table
        lines; /* node: { title: "NAME" label: "...N bytes (static)..." }, edge: { sourcename: "A" targetname: "B" ... } */
    function *functions;
    size_t count;
} graph;

_Noreturn static void fail(const char *const what, const char *const name, const char *const why)
{
    fprintf(stderr, "stack: %s%s%s\n", what, name, why);
    exit(EXIT_FAILURE);
}

/* A name without the file that gcc writes before it. */
static const char *short_name(const char *const name)
{
    const char *const colon = strrchr(name, ':');
    return colon == NULL ? name : colon + 1;
}

static size_t find(const graph *const g, const char *const name)
{
    size_t i = 0;
    while (i < g->count && strcmp(g->functions[i].name, name) != 0) {
        i++;
    }
    return i;
}

/* The number before " bytes (" in a label; the words behind it say whether the frame grows. */
static void read_frame(function *const f, const char *const label)
{
    const char *const bytes = strstr(label, " bytes (");
    const char *digit = bytes;
    while (digit != NULL && digit > label && digit[-1] >= '0' && digit[-1] <= '9') {
        digit--;
    }
    if (digit != bytes) {
        f->frame = strtol(digit, NULL, 10);
        f->grows = strncmp(bytes, " bytes (dynamic)", 16) == 0;
    }
}

static bool is_line(const graph *const g, const size_t row, const char *const kind)
{
    return strncmp(table_text(&g->lines, row, 0), kind, strlen(kind)) == 0;
}

static void visit(graph *const g, const char *const name, const size_t number)
{
    if (strcmp(name, "__indirect_call") == 0) {
        fail("a call through a pointer", "", "");
    }
    function *const f = &g->functions[number];
    if (number == g->count || f->frame < 0) {
        fail("the frame of ", short_name(name), " is not known");
    }
    if (f->active) {
        fail("recursion through ", short_name(name), "");
    }
    if (f->grows) {
        fail("the frame of ", short_name(name), " grows at run time");
    }
    if (f->deepest >= 0) {
        return;
    }
    f->active = true;
    f->next = number;
    long below = 0;
    for (size_t row = 0; row < g->lines.rows; row++) {
        if (is_line(g, row, "edge:") && strcmp(table_text(&g->lines, row, 1), name) == 0) {
            const char *const callee = table_text(&g->lines, row, 3);
            const size_t called = find(g, callee);
            visit(g, callee, called);
            if (g->functions[called].deepest > below) {
                below = g->functions[called].deepest;
                f->next = called;
            }
        }
    }
    f->deepest = f->frame + below;
    f->active = false;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fail("usage: stack FUNCTION <plant.ci", "", "");
    }
    graph g = {.lines = table_read("-", '"')};
    g.functions = table_memory(g.lines.rows + 1, sizeof *g.functions);
    size_t start = g.lines.rows;
    for (size_t row = 0; row < g.lines.rows; row++) {
        if (is_line(&g, row, "node:")) {
            function *const f = &g.functions[g.count];
            *f = (function){.name = table_text(&g.lines, row, 1), .frame = -1, .deepest = -1};
            read_frame(f, table_text(&g.lines, row, 3));
            start = strcmp(short_name(f->name), argv[1]) == 0 ? g.count : start;
            g.count++;
        }
    }
    if (start == g.lines.rows) {
        fail("there is no function ", argv[1], "");
    }
    visit(&g, g.functions[start].name, start);
    size_t at = start;
    for (bool more = true; more;) {
        printf("%6ld %s\n", g.functions[at].frame, short_name(g.functions[at].name));
        more = g.functions[at].next != at;
        at = g.functions[at].next;
    }
    printf("stack_of_step %ld\n", g.functions[start].deepest);
    free(g.functions);
    table_free(&g.lines);
    return EXIT_SUCCESS;
}
