/* The table on the terminal: from numbers to text, on any stream. */
#ifndef ISO_TOOLS_MONITOR_TABLE_H
#define ISO_TOOLS_MONITOR_TABLE_H

#include <stdio.h>

#include "tools/monitor/a2l.h"

/* Samples of a curve, one each TABLE_PERIOD seconds. */
enum { TABLE_CURVE = 32 };
#define TABLE_PERIOD 0.1

typedef struct table_row {
    const a2l_quantity *of;
    double value;
    double curve[TABLE_CURVE]; /* the newest last */
    size_t points;             /* of the curve; 0: the row has no value, and is not shown */
} table_row;

typedef struct table {
    table_row *rows; /* [count], one of each quantity */
    size_t count;
    double time; /* s */
    char state[A2L_TEXT_BYTES];
} table;

/* A table of all quantities, without values. */
void table_make(table *t, const a2l *a);
void table_free(table *t);

/* Sets the value of a row. */
void table_set(table_row *row, double value);

/* Takes the values of all rows that have one into their curves. */
void table_step(table *t);

/* Writes lines: name, value, unit and curve; then the statistics. */
void table_write(FILE *to, const table *t);

#endif
