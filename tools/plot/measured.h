/* The measurements of a report: its table, line by line, the methods and ranges of it, and the Pareto front. */
#ifndef ISO_TOOLS_PLOT_MEASURED_H
#define ISO_TOOLS_PLOT_MEASURED_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/plot/look.h"
#include "tools/table/table.h"

/* Columns of the table. */
enum { KIND, METHOD, STEP, STEPS, ERROR, ORDER, PER_STEP, PER_SECOND, TOLERANCE };

typedef struct measured {
    table rows;
    look methods[LOOKS_MOST]; /* those of the table */
    size_t count;
    double error[2]; /* least and greatest of what is drawn */
    double cost[2];
    double step[2]; /* ms */
} measured;

/* To be freed: `rows`. */
measured read_measured(const char *path);

double cost_of(const measured *m, size_t row);
double step_ms(const measured *m, size_t row);

/* Whether a line has a place in the picture: of this kind and method, NULL for all of them. */
bool is_drawn(const measured *m, size_t row, const char *kind, const char *method);

/* Whether any line has. */
bool has_points(const measured *m, const char *kind, const char *method);

/* The longest step of a fixed method, in ms; 0 if there is none. */
double longest_fixed_step(const measured *m);

/* The Pareto front has the points that no other point of the kind betters in error and in cost. This is the next one that
 * costs more than `cost`, 0 if there is none. */
size_t next_on_front(const measured *m, const char *kind, double cost);

#endif
