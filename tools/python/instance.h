/* Plants in a program of another language: as many as that has room for, each in a block of bytes of its own. It acts
 * as core/link does for a controller in lockstep, without a wire: commands are those of core/link/command.h, an
 * exchange is one call.
 *
 * Names are the same in float and in double, for look-ups by their text. Time is virtual: no tick is late.
 */
#ifndef ISO_PYTHON_INSTANCE_H
#define ISO_PYTHON_INSTANCE_H

#include "core/link/link.h"
#include "core/runtime/policy_counts.h"
#include "tools/client/inside.h"

/* A function that the library shows; all else in it is hidden, so that libraries of several plants stand in one
 * program. */
#define ISO_SHOWN __attribute__((visibility("default")))

/* What isoc writes beside the plant: its identity, and the places of the inputs that come in. */
extern const uint64_t iso_instance_identity;
extern const size_t iso_instance_wires;
extern const uint16_t iso_instance_inputs[];

/* The functions below, for a controller in C (tools/client/process.h). */
ISO_SHOWN extern const iso_inside iso_the_inside;

/* An input of a step, or of all steps of a record: where it is, or the first of so many; NULL: as it was, or as the
 * scene says. */
typedef struct iso_column {
    const real *values;
    size_t stride; /* from one step to the next: 0 or 1 */
} iso_column;

/* A plant; behind it stand its memory, that of a step that is made again, and its record. */
typedef struct iso_instance {
    iso_plant plant;
    iso_loop loop;
    iso_control control; /* its hash: FNV-1a over the bytes of the state after each tick */
    iso_commands commands;
    uint64_t ticks;              /* that the run has; 0: until it is ended */
    iso_link_statistics wire;    /* its inputs: steps whose inputs came in; all else 0 */
    uint64_t reported;           /* ticks of its virtual time */
    iso_policy_histogram policy; /* its counts, while another plant of the library has those of the model */
    uint8_t answer[ISO_FRAME_BYTES(ISO_LINK_LARGER(ISO_COMMAND_ANSWER_BYTES, ISO_LINK_COUNTS_BYTES))];
    bool running; /* from the start to the end */
    bool ended;   /* a run has been */
} iso_instance;

/* Bytes of an instance with all data behind it; and whether its model counts for all plants of it, so that no two of
 * them may step at once. */
ISO_SHOWN size_t iso_instance_bytes(void);
ISO_SHOWN bool iso_instance_is_alone(void);

/* Puts a plant into a block of so many bytes, which begins where a 64-bit word may. Returns its outputs, which stay
 * where they are; NULL where this processor, or its mode, computes other bits. */
ISO_SHOWN const real *iso_instance_open(iso_instance *instance);

/* Begins a run of so many ticks; 0: until it is ended. */
ISO_SHOWN void iso_instance_start(iso_instance *instance, uint64_t ticks);

/* Makes a step with these inputs, columns[iso_instance_wires]. */
ISO_SHOWN iso_inside_outcome iso_instance_step(iso_instance *instance, const iso_column *columns);

/* Makes so many steps, or until one is not made. Each output has a row of `room` reals, one behind the other: takes the
 * outputs into them, from the second real on, where the first are those before. *outcome is that of the last. Returns
 * how many were made. */
ISO_SHOWN uint64_t iso_instance_record(iso_instance *instance, uint64_t ticks, const iso_column *columns, real *rows,
                                       uint64_t room, iso_inside_outcome *outcome);

/* Ends the run. */
ISO_SHOWN void iso_instance_stop(iso_instance *instance);

/* Whether a run goes on. */
ISO_SHOWN bool iso_instance_runs(const iso_instance *instance);

/* Does the command of a payload, as it stands in a frame. Returns the payload of the answer, and its bytes; NULL where
 * there is no such command. */
ISO_SHOWN const uint8_t *iso_instance_ask(iso_instance *instance, const uint8_t *payload, size_t length,
                                          size_t *answered);

#endif
