/* The reference of a report: what the state is at a time, and how sure that is. */
#ifndef ISO_TOOLS_ACCURACY_REFERENCE_H
#define ISO_TOOLS_ACCURACY_REFERENCE_H

#include "tools/table/table.h"

/* Each line: the time, how much the two methods that it was computed by differ, and the state (agree.c). */
typedef struct reference {
    table lines;
    size_t states;
} reference;

enum { REFERENCE_TIME, REFERENCE_UNSURE, REFERENCE_STATE };

reference reference_read(const char *path);

/* The line of a time, as it is written there; -1 if there is none. */
int reference_at(const reference *r, const char *time);

/* The error of a state, whose numbers begin with this cell of a line: the 2-norm of the difference to a line of the
 * reference; infinite if one of them is no number. */
double reference_error(const reference *r, int line, const table *t, size_t row, size_t cell);

#endif
