/* The account of a run on its wire: the time of each exchange, the inputs, and the end. */
#ifndef ISO_TOOLS_LINK_ACCOUNT_H
#define ISO_TOOLS_LINK_ACCOUNT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/link/link.h"

/* Outputs that are younger than so many ticks can be answered. */
enum { ACCOUNT_OPEN = 4096 };

/* The content of the end frame. */
typedef struct account_end {
#define ACCOUNT_FIELD(name, value) uint64_t name;
    ISO_STREAM_COUNTS(ACCOUNT_FIELD)
    ISO_STREAM_WORDS(ACCOUNT_FIELD)
    iso_link_statistics link;
} account_end;

/* A row of the trace is a step that the plant did. A reset or a restore puts it to another tick in the same row. */
typedef struct account {
    uint64_t newest;              /* tick of the latest outputs, */
    uint64_t row;                 /* their row, */
    uint64_t seen;                /* when they were, in ns, */
    uint64_t shown[ACCOUNT_OPEN]; /* and when those of a tick were; 0: answered, or not seen */
    uint64_t *trips;    /* [exchanges] ns from outputs to the inputs that answer them: the controller's part */
    uint64_t *turns;    /* [turn_count] ns from the outputs of a tick to those of the next: the whole exchange */
    uint64_t *answered; /* [exchanges] the row of them */
    uint8_t *inputs;    /* [exchanges * input_bytes] as they came */
    size_t exchanges, room, input_bytes, turn_count, turn_room;
    bool moved; /* the next outputs are of another tick in the same row */
    bool ended;
    account_end end;
} account;

/* Takes note of frames from the plant, and from the controller, at a time in ns. */
void account_plant(account *a, uint8_t type, const uint8_t *payload, size_t length, uint64_t now);
void account_controller(account *a, uint8_t type, const uint8_t *payload, size_t length, uint64_t now);

/* The exchanges that led to a tick: the outputs of the last one may have been answered as well. In ns, 0 if there were
 * none. */
typedef struct account_trips {
    size_t count;
    uint64_t median, longest;             /* the controller's part */
    uint64_t whole_median, whole_longest; /* with the plant's, to the outputs of the next tick */
} account_trips;

/* Sorts both. */
account_trips account_sum(account *a);

void account_free(account *a);

#endif
