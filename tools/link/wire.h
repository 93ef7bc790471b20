/* The wire between a plant and a controller: passes on the bytes of each, and keeps account. */
#ifndef ISO_TOOLS_LINK_WIRE_H
#define ISO_TOOLS_LINK_WIRE_H

#include "tools/link/account.h"
#include "tools/link/direction.h"

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

/* The plant has gone: hands the controller the rest, for at most so many milliseconds, and says that nothing more
 * comes. */
void wire_finish(wire *w, int milliseconds);

#endif
