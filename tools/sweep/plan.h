/* The plan of a sweep, as isoc --sweep wrote it: tools/sweep/README.md. */
#ifndef SWEEP_PLAN_H
#define SWEEP_PLAN_H

#include <stdbool.h>
#include <stdint.h>

#include "tools/table/table.h"

/* A variable, or a result. */
typedef struct plan_column {
    const char *name, *unit;
    const char *sort; /* of a variable method, step or number; of a result its function */
    int place; /* of a variable among the tunables of the plant, -1: it is built in; of a result among its outputs,
                  -1: it is of none */
} plan_column;

typedef struct plan {
    const char *folder;
    uint64_t width; /* a part has as many runs, or a multiple; the last one may have fewer */
    uint64_t runs, parts, plants, variable_count, column_count, output_count;
    plan_column *variables, *columns;
    const char *outputs; /* names, separated by commas */
    table text;
    size_t first_run; /* its row in the text; a run has the number of its plant, then the cells of each variable */
} plan;

/* A cell of the line of a run. */
typedef struct plan_cell {
    const char *text;
    const char *literal; /* of the plant's type; empty where the value is built in */
} plan_cell;

/* Ends the program with a message if FOLDER/plan is no plan. */
plan plan_read(const char *folder);

/* Makes parts of so many runs, or a multiple of that; they become fewer where the plan has more parts. */
void plan_widen(plan *p, unsigned width);

/* The first run of a part; of the one behind the last the number of runs. */
uint64_t plan_first(const plan *p, uint64_t part);

/* Which plant the run is of, and its cells[variable_count]. */
uint64_t plan_cells(const plan *p, uint64_t run, plan_cell *cells);

/* The name of the file of a part below the folder. */
enum { PLAN_NAME_BYTES = 48 };
const char *plan_part_name(uint64_t part, char name[PLAN_NAME_BYTES]);

/* Whether the part is there, and so whole. */
bool plan_has_part(const plan *p, uint64_t part);

/* Ends the program with a message. */
_Noreturn void plan_fail(const char *what, const char *which);

#endif
