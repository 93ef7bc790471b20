#include "tools/table/table.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool separates(const char c, const char separator)
{
    return c == separator || (separator == ' ' && c == '\t');
}

/* Splits a line in place. Its cells go to `cell` unless that is NULL; returns how many there are. */
static size_t split(char *const line, char *const end, const char separator, char **const cell)
{
    size_t cells = 0;
    char *at = line;
    while (at < end || (separator != ' ' && at == end)) {
        char *start = at;
        while (separator == ' ' && start < end && separates(*start, separator)) {
            start++;
        }
        if (separator == ' ' && start == end) {
            break;
        }
        char *stop = start;
        while (stop < end && !separates(*stop, separator)) {
            stop++;
        }
        if (cell != NULL) {
            cell[cells] = start;
            *stop = '\0';
        }
        cells++;
        at = stop + 1;
    }
    return cells;
}

/* Goes over all lines: counts lines and cells, and keeps them if there is room for them already. */
static size_t take_lines(table *const t, const char separator)
{
    size_t cells = 0;
    size_t rows = 0;
    char *line = t->text;
    while (*line != '\0') {
        char *const end = line + strcspn(line, "\n");
        const bool last = *end == '\0';
        if (t->first != NULL) {
            t->first[rows] = cells;
        }
        cells += split(line, end, separator, t->cell == NULL ? NULL : t->cell + cells);
        rows++;
        if (last) {
            break;
        }
        line = end + 1;
    }
    if (t->first != NULL) {
        t->first[rows] = cells;
    }
    t->rows = rows;
    return cells;
}

table table_read(const char *const path, const char separator)
{
    size_t bytes = 0;
    table read = {.path = path};
    read.text = strcmp(path, "-") == 0 ? file_rest(stdin, &bytes) : file_content(path, &bytes);
    if (read.text == NULL) {
        quit("%s: %s", path, strerror(errno));
    }
    const size_t cells = take_lines(&read, separator);
    read.cell = memory_for(cells, sizeof *read.cell);
    read.first = memory_for(read.rows + 1, sizeof *read.first);
    (void)take_lines(&read, separator);
    return read;
}

void table_free(table *const t)
{
    free(t->text);
    free(t->cell);
    free(t->first);
}

size_t table_cells(const table *const t, const size_t row)
{
    return t->first[row + 1] - t->first[row];
}

const char *table_text(const table *const t, const size_t row, const size_t column)
{
    return column < table_cells(t, row) ? t->cell[t->first[row] + column] : "";
}

double table_number(const table *const t, const size_t row, const size_t column)
{
    return strtod(table_text(t, row, column), NULL);
}
