/* Values over time as CSV, in the form of trace.csv: a line with `t` and names, then one for each tick. */
#ifndef ISO_TOOLS_MONITOR_RECORD_H
#define ISO_TOOLS_MONITOR_RECORD_H

#include "tools/monitor/master.h"
#include "tools/monitor/table.h"

/* A file that is being written: outputs and inputs at every tick. */
typedef struct record {
    FILE *file; /* NULL: nothing is recorded */
    const a2l *of;
    const a2l_quantity *columns[MASTER_LIST_VALUES];
    uint8_t tables[MASTER_LIST_VALUES]; /* of each */
    size_t count;
    double values[MASTER_LIST_VALUES];
    uint64_t tick, rows, lost; /* the plant could not send so many samples, or more */
} record;

/* Begins: the plant sends its outputs and inputs at every tick, as far as they go into a list of 64. False: m->problem
 * says why. */
bool record_begin(record *r, const a2l *a, master *m, const char *path);

/* Ends. False: m->problem says why. */
bool record_end(record *r, master *m);

/* Replays the rows of a file into a table, each at its time; calls `shown` each TABLE_PERIOD of it, until that returns
 * false. False: problem[] has FILE:LINE and the problem. */
typedef bool record_shown(void *context, const table *t);
bool record_replay(const char *path, const a2l *a, table *t, record_shown *shown, void *context, char *problem,
                   size_t problem_bytes);

#endif
