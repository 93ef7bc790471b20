/* A master of XCP 1.x on a socket: asks the slave of a plant (core/xcp). Each call returns whether it was done; if not,
 * m->problem says why. */
#ifndef ISO_TOOLS_MONITOR_MASTER_H
#define ISO_TOOLS_MONITOR_MASTER_H

#include "core/xcp/packet.h"
#include "tools/monitor/a2l.h"

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

/* Connects to unix:PATH, tcp:HOST:PORT or udp:HOST:PORT, and makes sure that the plant is that of the A2L; with the
 * patience that was set. */
bool master_connect(master *m, const char *address, bool is_serial, const char *epk);
bool master_disconnect(master *m);

/* Reads count bytes from an address on, up to 255. */
bool master_read(master *m, uint32_t address, uint8_t *to, uint8_t count);

/* Sets a tunable, between two ticks. */
bool master_set(master *m, const a2l_quantity *q, double value);

/* Lets the plant run for so many ticks, 0: without an end; or pauses it. */
bool master_run(master *m, uint32_t ticks);
bool master_pause(master *m);

/* Writes count bytes, up to MASTER_WRITE_MOST, from an address on: of the record of snapshots. */
enum { MASTER_WRITE_MOST = ISO_XCP_MAX_CTO - 8 };
bool master_write(master *m, uint32_t address, const uint8_t *bytes, uint8_t count);

/* Lets the plant take a snapshot into its record, and restore the one of so many bytes there. *answer: the result
 * (iso_control_answer); *at, *bytes: the record. */
bool master_take(master *m, uint8_t *answer, uint32_t *at, uint32_t *bytes);
bool master_restore(master *m, uint32_t bytes, uint8_t *answer);

/* Measures so many quantities at every tick. Their packets are those of table 0, 1 and so on: a byte with the number of
 * the table, in table 0 four bytes with the tick, then values; tables[i] is the table of quantity i. */
bool master_measure(master *m, const a2l_quantity *const *of, size_t count, uint8_t tables[]);
bool master_stop(master *m);

/* Takes the samples that come within so many milliseconds. */
bool master_wait(master *m, int milliseconds);

#endif
