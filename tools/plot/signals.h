/* The outputs of a run: the table that build/trace writes, with their units, in groups that share a panel. */
#ifndef ISO_TOOLS_PLOT_SIGNALS_H
#define ISO_TOOLS_PLOT_SIGNALS_H

#include <stdbool.h>
#include <stddef.h>

#include "tools/table/table.h"

enum { VECTOR = 3, QUATERNION = 4, MEMBERS_MOST = QUATERNION, STEM_BYTES = 256 };

/* One output, the x, y and z of a vector, or the w, x, y and z of a quaternion. */
typedef struct group {
    char stem[STEM_BYTES]; /* the name without _x of a component */
    const char *unit;      /* "" if it has none, or none is known */
    size_t column[MEMBERS_MOST];
    size_t members;
} group;

typedef struct signals {
    table rows;  /* the first names the columns; column 0 is the time */
    table units; /* its second line has them */
    table run;   /* what make run prints: words and values */
    size_t columns, count;
    double *value; /* value[count * columns] */
    double *least; /* of each column */
    double *most;
    group *groups;
    size_t group_count;
} signals;

/* Reads DIRECTORY/trace.csv, units.csv and summary.txt. */
signals signals_read(const char *directory);

/* Leaves the groups of these names, in their order. Exits if there is no such group. */
void signals_choose(signals *s, char *const *names, size_t count);

void signals_free(signals *s);

double signal_at(const signals *s, size_t row, size_t column);

/* Scene, method, step and real, as a title in quotes. */
void put_title(const signals *s);

/* A name with the unit of the group, in quotes: "hinge_angle, rad"; a pure number has no unit. */
void put_label(const group *g, const char *before, const char *name);

/* The points of a column over time, less `zero`: of each stretch of the rows the least and the greatest, in their order, so
 * that nothing fast is lost. */
void put_points(const signals *s, size_t column, double zero, size_t stretches);

/* The same as a block of data, called $column with its number. */
void put_column(const signals *s, size_t column, double zero, size_t stretches);

/* The colours of the members of a group. */
extern const char *const colours[MEMBERS_MOST];

#endif
