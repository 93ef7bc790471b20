#include "tools/table/table.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Splits a line in place into `cell`; returns how many cells there are. */
static size_t split(char *at, const char *const separators, char **const cell)
{
    const bool by_blanks = *separators == ' ';
    for (size_t cells = 0;; at++) {
        at += by_blanks ? strspn(at, separators) : 0;
        if (by_blanks && *at == '\0') {
            return cells;
        }
        cell[cells++] = at;
        at += strcspn(at, separators);
        if (*at == '\0') {
            return cells;
        }
        *at = '\0';
    }
}

table table_read(const char *const path, const char separator)
{
    const char separators[] = {separator, separator == ' ' ? '\t' : '\0', '\0'};
    size_t bytes = 0, cells = 0, cells_most = 1, rows_most = 1;
    table read = {.path = path};
    read.text = strcmp(path, "-") == 0 ? file_rest(stdin, &bytes) : file_content(path, &bytes);
    if (read.text == NULL) {
        quit("%s: %s", path, strerror(errno));
    }
    for (const char *at = read.text; *at != '\0'; at++) {
        rows_most += *at == '\n';
        cells_most += *at == '\n' || strchr(separators, *at) != NULL;
    }
    read.cell = memory_for(cells_most, sizeof *read.cell);
    read.first = memory_for(rows_most + 1, sizeof *read.first);
    for (char *line = read.text, *next = NULL; line != NULL && *line != '\0'; line = next) {
        char *const end = strchr(line, '\n');
        next = end == NULL ? NULL : end + 1;
        if (end != NULL) {
            *end = '\0';
        }
        read.first[read.rows++] = cells;
        cells += split(line, separators, read.cell + cells);
    }
    read.first[read.rows] = cells;
    return read;
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
