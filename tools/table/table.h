/* A table in a text file: lines of cells. The tools read their numbers from such files. */
#ifndef ISO_TOOLS_TABLE_TABLE_H
#define ISO_TOOLS_TABLE_TABLE_H

#include "tools/file/file.h"

typedef struct table {
    char *text;       /* the whole file, each cell with a final zero byte */
    char **cell;      /* cell[cells] */
    size_t *first;    /* first[rows + 1]: the number of the first cell of each line */
    size_t rows;      /* lines, with the one that names the columns, if there is one */
    const char *path; /* for messages */
} table;

/* Reads the file, "-" for the standard input. Cells are separated by the character; ' ' stands for any number of spaces
 * and tabs. Exits with a message if the file cannot be read. The memory stays: cells are read until the program
 * ends. */
table table_read(const char *path, char separator);

size_t table_cells(const table *t, size_t row);

/* The cell of a line, "" if the line is shorter; as a number 0 if it is none. */
const char *table_text(const table *t, size_t row, size_t column);
double table_number(const table *t, size_t row, size_t column);

#endif
