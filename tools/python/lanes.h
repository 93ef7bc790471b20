/* Plants side by side, each lane with its own states, inputs, tunables and outputs: the interface of the library
 * tools/python/lanes.c. A row of numbers has one for each lane. */
#ifndef ISO_PYTHON_LANES_H
#define ISO_PYTHON_LANES_H

#include <stdbool.h>
#include <stddef.h>

#include "core/numbers/real.h"

#define ISO_SHOWN __attribute__((visibility("default")))

typedef struct iso_side iso_side;

typedef enum iso_side_kind { ISO_SIDE_STATES, ISO_SIDE_INPUTS, ISO_SIDE_TUNABLES, ISO_SIDE_OUTPUTS } iso_side_kind;

/* The numbers of an input: how far it is from one step to the next, and from one lane to the next; NULL: as it was. */
typedef struct iso_side_column {
    const iso_scalar *values;
    size_t of_step, of_lane;
} iso_side_column;

/* Bytes of a block, the alignment of its first, lanes, and bytes of a number. */
enum { ISO_SIDE_SIZES = 4 };
ISO_SHOWN extern const size_t iso_side_sizes[ISO_SIDE_SIZES];

/* The name of a quantity; NULL behind the last. */
ISO_SHOWN const char *iso_side_name(iso_side_kind kind, uint16_t i);

/* Whether an input is a function of time, and so cannot be set. */
ISO_SHOWN bool iso_side_is_driven(iso_side *side, uint16_t input);

/* Puts all lanes to tick 0. Returns false where this processor, or its mode, computes other bits. */
ISO_SHOWN bool iso_side_start(iso_side *side);

/* The rows of numbers of a kind, one behind the other, which stay where they are. */
ISO_SHOWN void *iso_side_numbers(iso_side *side, iso_side_kind kind);

/* Puts the lanes whose byte of chosen[lanes] is not 0 to their start, with the tunables of the scene; the tick, which
 * is common, goes on. */
ISO_SHOWN void iso_side_restart(iso_side *side, const uint8_t *chosen);

/* The hash of a lane's trajectory since its start, and the tick that its guard ended; 0: none. */
ISO_SHOWN uint64_t iso_side_hash(const iso_side *side, unsigned lane);
ISO_SHOWN uint64_t iso_side_stopped_at(const iso_side *side, unsigned lane);

/* Makes so many steps, or until no lane runs, with columns[inputs]. Each output has ticks + 1 rows in `rows`, the first
 * before the first step; NULL: outputs are not stored. Returns how many were made. */
ISO_SHOWN uint64_t iso_side_run(iso_side *side, uint64_t ticks, const iso_side_column *columns, iso_scalar *rows);

#endif
