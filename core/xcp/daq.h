/* DAQ: lists of measured values at every tick, or at every n-th. A list has tables (ODT), each of which is one
 * packet; a table has entries, each of which is bytes of memory. The master makes them, of a pool of fixed size, in
 * this order: all lists, the tables of each, the entries of each table. There is one event: a tick has ended, its
 * outputs are published. The next step takes the values of a list of the other direction (stimulation.h). */
#ifndef ISO_CORE_XCP_DAQ_H
#define ISO_CORE_XCP_DAQ_H

#include "core/xcp/access.h"

enum { ISO_XCP_LISTS = 4, ISO_XCP_TABLES = 16, ISO_XCP_ENTRIES = 64 };

/* Bits of a list's mode, as SET_DAQ_LIST_MODE and GET_DAQ_LIST_MODE have them. */
enum { ISO_XCP_SELECTED = 0x01, ISO_XCP_STIM = 0x02, ISO_XCP_STAMPED = 0x10, ISO_XCP_RUNNING = 0x40 };

/* Packets of a list are numbered by its tables, with this bit in the first one behind a loss. */
enum { ISO_XCP_OVERLOAD = 0x80 };

typedef struct iso_xcp_entry {
    const uint8_t *at; /* in the plant's memory */
    uint8_t bytes;     /* 0: not written */
} iso_xcp_entry;

/* Consecutive elements of an array. */
typedef struct iso_xcp_part {
    uint8_t first, count;
} iso_xcp_part;

typedef struct iso_xcp_list {
    iso_xcp_part tables;
    uint8_t mode;
    uint8_t prescaler; /* each so many events are one sample */
    uint8_t passed;    /* events since the last one */
    bool overloaded;   /* since the last sample that was sent, one was lost */
} iso_xcp_list;

/* The kind that was allocated last: the standard has an order of them. */
typedef enum iso_xcp_stage {
    ISO_XCP_UNMADE,
    ISO_XCP_FREED,
    ISO_XCP_LISTED,
    ISO_XCP_TABLED,
    ISO_XCP_MADE
} iso_xcp_stage;

typedef struct iso_xcp_daq {
    iso_xcp_list lists[ISO_XCP_LISTS];
    iso_xcp_part tables[ISO_XCP_TABLES]; /* their entries */
    iso_xcp_entry entries[ISO_XCP_ENTRIES];
    iso_xcp_stage stage;
    uint8_t list_count, table_count, entry_count;
    uint8_t list, entry, entries_left; /* where WRITE_DAQ writes; entries_left 0: nowhere */
} iso_xcp_daq;

iso_xcp_error iso_xcp_daq_alloc_lists(iso_xcp_daq *daq, uint16_t count);
iso_xcp_error iso_xcp_daq_alloc_tables(iso_xcp_daq *daq, uint16_t list, uint8_t count);
iso_xcp_error iso_xcp_daq_alloc_entries(iso_xcp_daq *daq, uint16_t list, uint8_t table, uint8_t count);
iso_xcp_error iso_xcp_daq_point(iso_xcp_daq *daq, uint16_t list, uint8_t table, uint8_t entry);

/* Whether so many entries can be written from the pointer on; and writes one of them. */
iso_xcp_error iso_xcp_daq_takes(const iso_xcp_daq *daq, uint8_t count);
iso_xcp_error iso_xcp_daq_write(iso_xcp_daq *daq, const uint8_t *at, uint8_t bytes);
iso_xcp_error iso_xcp_daq_clear(iso_xcp_daq *daq, uint16_t list);
iso_xcp_error iso_xcp_daq_mode(iso_xcp_daq *daq, uint16_t list, uint8_t mode, uint8_t prescaler);

/* Whether a list can be started: all its tables have entries, and fit into packets and a sample. */
iso_xcp_error iso_xcp_daq_check(const iso_xcp_daq *daq, uint16_t list);
void iso_xcp_daq_start(iso_xcp_daq *daq, uint16_t list);
void iso_xcp_daq_stop(iso_xcp_daq *daq, uint16_t list);
bool iso_xcp_daq_runs(const iso_xcp_daq *daq);

/* An event: whether it is a sample of this list. */
bool iso_xcp_daq_due(iso_xcp_daq *daq, uint8_t list);

/* The packet of a list's table: the table's number, of a list that is stamped in the first one the tick, then the
 * data. `to` has ISO_XCP_MAX_DTO bytes. Returns its length. */
uint16_t iso_xcp_daq_packet(const iso_xcp_daq *daq, uint8_t list, uint8_t table, uint32_t tick, uint8_t *to);

#endif
