/* The plan of a sweep: many runs of one scene, with other values of constants, tunables and faults, methods and steps.
 *
 * A number that a plant takes at its start is a value in the plan; one that is built into it makes a variation, another
 * plant. The language of --sweep, and the plan, stand in tools/sweep/README.md. */
#ifndef ISOC_SWEEP_SWEEP_H
#define ISOC_SWEEP_SWEEP_H

#include "tools/isoc/plant/plant.h"

/* The request of isoc --sweep. */
typedef struct sweep_request {
    const char *set, *columns; /* the variables, and the columns of the table */
    const char *runs, *seed;   /* of random values; NULL */
    const char *folder;
} sweep_request;

/* variables.c: the variables. */

typedef enum sweep_sort { SWEEP_METHOD, SWEEP_STEP, SWEEP_NUMBER } sweep_sort;

/* A value that is listed: a number, or the word of a method. */
typedef struct sweep_value {
    double number;
    const char *word;
    bool is_round; /* a number that was computed: it has twelve digits */
} sweep_value;

typedef enum sweep_law { SWEEP_LISTED, SWEEP_UNIFORM, SWEEP_NORMAL } sweep_law;

typedef struct sweep_variable {
    const char *name;
    place at;
    sweep_sort sort;
    int tunable; /* its place among the tunables and faults; -1: none */
    dimension dim;
    unit si;               /* as `unit_text` writes it */
    const char *unit_text; /* empty: a plain number */
    sweep_law law;
    double first, second; /* of a random value: the limits, or the mean and the standard deviation */
    LIST_OF(sweep_value) listed;
} sweep_variable;

typedef LIST_OF(sweep_variable) sweep_variables;

/* A tunable or a fault by its name in a scene, or in a header; -1: none. */
int sweep_tunable_called(const mechanism *m, const char *called);

/* Notes problems. */
sweep_variables sweep_read_variables(source *s, graph *g, const scene *written, const plant *p, const script *set);

/* draws.c: random values. That of a run follows from the seed, the name and the number of the run. */

double sweep_draw(uint64_t seed, const char *called, uint64_t run, sweep_law law, double first, double second);

/* columns.c: the columns of the table of runs. */

typedef struct sweep_column {
    const char *title, *unit;
    const char *function; /* max, final, ..., hash */
    int output;           /* of the plant; -1: of none */
} sweep_column;

typedef LIST_OF(sweep_column) sweep_columns;

/* Notes problems. */
sweep_columns sweep_read_columns(source *s, const plant *p, const script *columns);

/* plan.c: the runs. */

/* Notes each tunable of the list, 'a; b' or NULL, that is built into this plant: a run could not set it. */
void sweep_check_varied(source *s, const mechanism *m, const char *vary);

/* Writes the plan into the folder. Returns false after reporting problems. */
bool sweep_run(source *s, graph *g, const scene *written, const plant *p, const sweep_request *r);

#endif
