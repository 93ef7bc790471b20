/* Declarations shared by the files of the monitor. */
#ifndef ISO_TOOLS_MONITOR_MONITOR_H
#define ISO_TOOLS_MONITOR_MONITOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "core/xcp/packet.h"

/* a2l.c: the quantities of a plant, by its A2L (ASAP2 1.6), as far as isoc writes it: quantities with their addresses,
 * types, units and limits. */

enum { A2L_TEXT_BYTES = 128 };

typedef enum a2l_type { A2L_FLOAT, A2L_DOUBLE, A2L_UNSIGNED, A2L_SIGNED } a2l_type;

typedef struct a2l_quantity {
    char name[A2L_TEXT_BYTES];
    char unit[A2L_TEXT_BYTES];
    double least, most;
    uint32_t address;
    a2l_type type;
    bool is_tunable;
} a2l_quantity;

typedef struct a2l {
    a2l_quantity *quantities; /* [count], in the order of the file */
    size_t count;
    double step; /* s; 0 where the file does not say it */
    char epk[A2L_TEXT_BYTES];
} a2l;

/* Reads a file. If it is no A2L of isoc, ends the program with FILE:LINE, the problem and the right form. */
a2l a2l_read(const char *path);

size_t a2l_bytes(a2l_type type);

/* The number that the bytes at `from` are. */
double a2l_value(a2l_type type, const uint8_t *from);

/* The quantity of a name, which may lack its prefix (`pole` for `y.pole`); NULL if there is none. */
const a2l_quantity *a2l_find(const a2l *in, const char *name);

/* master.c: a master of XCP 1.x on a socket: asks the slave of a plant (core/xcp). Each call returns whether it was
 * done; if not, m->problem says why. */

enum { MASTER_ROOM = 65536, MASTER_PATIENCE_MS = 5000, MASTER_LIST_VALUES = 64 };

/* Takes a packet of measured data. */
typedef void master_sample(void *context, const uint8_t *packet, size_t length);

typedef struct master {
    int file;
    int patience_ms; /* how long an answer is waited for */
    bool is_serial;  /* frames are those of a serial line (core/xcp/transport.h) */
    uint16_t counter;
    uint8_t data[MASTER_ROOM]; /* that has come and was not taken */
    size_t used;
    char problem[256];
    master_sample *sample; /* NULL: samples are dropped */
    void *context;
} master;

/* Puts a message into m->problem. Returns false. */
__attribute__((format(printf, 2, 3))) bool master_fail(master *m, const char *format, ...);

/* Connects to unix:PATH, tcp:HOST:PORT or udp:HOST:PORT, and makes sure that the plant is that of the A2L; with the
 * patience that was set. */
bool master_connect(master *m, const char *address, bool is_serial, const char *epk);
bool master_disconnect(master *m);

/* Reads count bytes from an address on; those of a block are of one tick. */
enum { MASTER_BLOCK = UINT8_MAX };
bool master_read(master *m, uint32_t address, uint8_t *to, uint32_t count);

/* Sets a tunable, between two ticks. */
bool master_set(master *m, const a2l_quantity *q, double value);

/* Lets the plant run for so many ticks, 0: without an end; or pauses it. */
bool master_run(master *m, uint32_t ticks);
bool master_pause(master *m);

/* Writes count bytes from an address on: of the record of snapshots. */
bool master_write(master *m, uint32_t address, const uint8_t *bytes, uint32_t count);

/* Lets the plant take a snapshot into its record, and restore the one of so many bytes there. *answer: the result
 * (iso_control_answer); *at, *bytes: the record. */
bool master_take(master *m, uint8_t *answer, uint32_t *at, uint32_t *bytes);
bool master_restore(master *m, uint32_t bytes, uint8_t *answer);

/* Measures so many quantities at every tick. Their packets are those of table 0, 1 and so on: a byte with the number of
 * the table, in table 0 four bytes with the tick, then values; tables[i] is the table of quantity i. */
bool master_measure(master *m, const a2l_quantity *const *quantities, size_t count, uint8_t tables[]);
bool master_stop(master *m);

/* Takes the samples that come within so many milliseconds. */
bool master_wait(master *m, int milliseconds);

/* snapshot.c: snapshots of a plant as files (core/runtime/snapshot.h). */

/* Takes a snapshot of the plant and writes it to the file, which is there only when it is whole. False: m->problem says
 * why. */
bool snapshot_save(master *m, const char *path);

/* Pauses the plant and puts it to the snapshot in the file, where it rests; or it goes on from where it was, paused.
 * False: m->problem says why. */
bool snapshot_load(master *m, const char *path);

/* display.c: the table on the terminal: from numbers to text, on any stream. */

/* Samples of a curve, one each DISPLAY_PERIOD seconds. */
enum { DISPLAY_CURVE = 32 };
#define DISPLAY_PERIOD 0.1

typedef struct display_row {
    const a2l_quantity *quantity;
    double value;
    double curve[DISPLAY_CURVE]; /* the newest last */
    size_t points;               /* of the curve; 0: the row has no value, and is not shown */
} display_row;

typedef struct display {
    display_row *rows; /* [count], one of each quantity */
    size_t count;
    double time; /* s */
    bool rests;  /* the plant */
} display;

/* A table of all quantities, without values. */
void display_make(display *d, const a2l *a);

/* Sets the value of a row. */
void display_set(display_row *row, double value);

/* Takes the values of all rows that have one into their curves. */
void display_step(display *d);

/* Writes lines: name, value, unit and curve; then the statistics. */
void display_write(FILE *to, const display *d);

/* record.c: values over time as CSV, in the form of trace.csv: a line with `t` and names, then one for each tick. */

/* A file that is being written: outputs and inputs at every tick. */
typedef struct record {
    FILE *file; /* NULL: nothing is recorded */
    const a2l *description;
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

/* Replays the rows of a file into a display, each at its time; calls `shown` each DISPLAY_PERIOD of it, until that
 * returns false. Ends the program with FILE:LINE and the problem where it is no record. */
typedef bool record_shown(void *context);
void record_replay(const char *path, const a2l *a, display *d, record_shown *shown, void *context);

#endif
