/* Declarations shared by the files of `link`. */
#ifndef ISO_TOOLS_LINK_LINK_H
#define ISO_TOOLS_LINK_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/link/frame.h"
#include "core/link/link.h"

/* account.c: the account of a run on its wire: the time of each exchange, the inputs, and the end. */

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
    uint64_t newest;              /* tick of the latest outputs */
    uint64_t row;                 /* of the latest outputs */
    uint64_t arrival;             /* of the latest outputs, ns */
    uint64_t shown[ACCOUNT_OPEN]; /* ns: arrival of the outputs of a tick; 0: answered, or not seen */
    uint64_t *trips;    /* [exchanges] ns from outputs to the inputs that answer them: the controller's part */
    uint64_t *rounds;   /* [round_count] ns from the outputs of a tick to those of the next: the whole exchange */
    uint64_t *answered; /* [exchanges] the row of them */
    uint8_t *inputs;    /* [exchanges * input_bytes] as they came */
    size_t exchanges, input_bytes, round_count;
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

/* columns.c: the inputs of a run as columns of its table. */

/* Adds the inputs to DIRECTORY/trace.csv and units.csv, by the names and units in the header that isoc wrote for a
 * controller. The row of a tick has the inputs that answered its outputs; without an answer, the last ones; before
 * these, 0. */
void columns_add(const char *directory, const char *header, const account *a);

/* direction.c: one direction of a wire: bytes from one end go out at the other, frame by frame; damaged frames as they
 * are. */

/* More than the largest frame, of 65535 outputs in double. */
enum { DIRECTION_FRAME_BYTES = 1 << 20, DIRECTION_QUEUE_BYTES = 3 << 20 };

typedef struct direction {
    iso_frame_reader reader;
    uint8_t frame[DIRECTION_FRAME_BYTES]; /* the buffer of the reader */
    uint8_t piece[DIRECTION_FRAME_BYTES]; /* the same as it came */
    size_t piece_bytes;
    uint8_t queue[DIRECTION_QUEUE_BYTES]; /* on its way out */
    size_t queued;
} direction;

/* Receives a whole frame: its type, and its payload, which it may change. Returns whether it has changed it. */
typedef bool direction_look(void *context, uint8_t *frame, size_t length);

void direction_start(direction *w);

/* Whether it has room for more bytes. */
bool direction_has_room(const direction *w);

/* Reads the received bytes. False at the end of the stream. */
bool direction_read(direction *w, int file, direction_look *look, void *context);

/* Writes the waiting bytes. False if the other end is closed. */
bool direction_write(direction *w, int file);

/* wire.c: the wire between a plant and a controller: passes on the bytes of each, and keeps account. */

enum { WIRE_NONE = -1 };

typedef struct wire {
    int plant, listener, controller; /* descriptors; WIRE_NONE */
    int mode;                        /* of a run, in place of the controller's choice; WIRE_NONE: that choice */
    uint64_t heard;                  /* when bytes came last, in ns of wire_clock */
    direction outwards, inwards;     /* from the plant, and to it */
    account account;
} wire;

typedef enum wire_event { WIRE_SILENT, WIRE_PASSED, WIRE_PLANT_GONE } wire_event;

/* A clock in ns. */
uint64_t wire_clock(void);

/* Opens a wire that waits for a controller at a path. Returns the descriptor that is the plant's end. */
int wire_open(wire *w, const char *path, int mode);

/* Waits for bytes from either side, at most so many milliseconds, and passes them on. Controllers may come and go. */
wire_event wire_pass(wire *w, int milliseconds);

/* The controller has gone: asks the plant in its place to end the run. Returns whether that was sent. */
bool wire_end(wire *w);

/* The plant has gone: hands the controller the rest, for at most so many milliseconds, and closes the stream. */
void wire_finish(wire *w, int milliseconds);

#endif
