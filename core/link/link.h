/* The plant's side of a link to a controller: frames of inputs come in, frames of outputs go out, tick by tick.
 *
 * In lockstep the plant makes the step from a tick when the inputs that answer the outputs of that tick have come: the
 * same trajectory as without a wire. Ticks of the port that pass meanwhile count neither as lost nor as late. In a free
 * run the tick does not wait: the latest values hold, and late and missing frames are counted. core/link/README.md has
 * the frames, byte by byte. */
#ifndef ISO_CORE_LINK_LINK_H
#define ISO_CORE_LINK_LINK_H

#include "core/application/stream.h"
#include "core/link/command.h"
#include "core/link/frame.h"
#include "core/link/interface.h"
#include "port/channel.h"

#define iso_link_open ISO_REAL_NAME(iso_link_open)
#define iso_link_begin ISO_REAL_NAME(iso_link_begin)
#define iso_link_tick ISO_REAL_NAME(iso_link_tick)
#define iso_link_end ISO_REAL_NAME(iso_link_end)
#define iso_link_restore ISO_REAL_NAME(iso_link_restore)
#define iso_the_link ISO_REAL_NAME(iso_the_link)

/* As the tables of core/wire/protocol.h have them. */
#define ISO_LINK_TYPE_CONSTANT(name, letter) ISO_LINK_##name = (letter),
typedef enum iso_link_type { ISO_LINK_TYPE_LIST(ISO_LINK_TYPE_CONSTANT) } iso_link_type;

#define ISO_LINK_CONSTANT(name, number, words) ISO_LINK_##name = (number),
typedef enum iso_link_reason { ISO_LINK_REASON_LIST(ISO_LINK_CONSTANT) } iso_link_reason;
typedef enum iso_link_mode { ISO_LINK_MODE_LIST(ISO_LINK_CONSTANT) ISO_LINK_MODES } iso_link_mode;

/* Bytes of payload. No command or answer is longer than that with the words of the end frame. */
#define ISO_LINK_LARGER(a, b) ((a) < (b) ? (b) : (a))
#define ISO_LINK_TICK_BYTES(reals) ((0 ISO_LINK_OUTPUTS_FIELDS(ISO_FIELD_BYTES)) + (reals) * sizeof(real))
#define ISO_LINK_END_BYTES (ISO_LINK_END_WORDS * ISO_BYTES_OF_U64)
#define ISO_LINK_COUNTS_BYTES ((0 ISO_LINK_ANSWER_FIELDS(ISO_FIELD_BYTES)) + ISO_LINK_END_BYTES)

/* Bytes of a buffer for the frames of a plant. */
#define ISO_LINK_BYTES(wires, outputs)                                                                                 \
    ISO_FRAME_BYTES(ISO_LINK_LARGER(ISO_LINK_TICK_BYTES(ISO_LINK_LARGER((size_t)(wires), (size_t)(outputs))),          \
                                    ISO_LINK_COUNTS_BYTES))

typedef struct iso_link {
    const iso_interface *interface;
    iso_loop *loop;
    iso_frame_reader reader;
    iso_link_statistics statistics; /* of the run */
    iso_control control;            /* its hash: FNV-1a over the bytes of the state after each tick */
    iso_commands commands;
    uint64_t ticks;    /* that the run has; 0: until it is ended */
    uint64_t answered; /* the newest inputs answer tick answered - 1; 0: none have come */
    uint64_t age;      /* of the newest inputs: ticks since the one that took them, or since the start */
    iso_link_mode mode;
    bool once;        /* the program makes one run */
    bool running;     /* from the start to the end frame */
    bool ended;       /* a run has been */
    bool is_starting; /* a start has come that is not carried out yet */
    bool leaving;     /* an end has been asked for */
    bool stopped;     /* by the guard, or by a policy with a tick that was its last */
    bool fresh;       /* values have come since the last tick */
} iso_link;

/* The link of the program. */
extern iso_link iso_the_link;

/* Opens the link of a loop that has been started. */
void iso_link_open(iso_link *link, const iso_interface *interface, iso_loop *loop, bool once);

/* Rests until a start comes; then puts the plant to tick 0, and sends its outputs. */
void iso_link_begin(iso_link *link);

/* Does the next tick of the run. Returns false, and does none, if the run is over: all ticks are done, the guard or a
 * policy has stopped it, or the controller has ended it or started another. */
bool iso_link_tick(iso_link *link);

/* Puts the plant to the snapshot of the interface, for a service: while it rests, or when the guard has stopped it. Its
 * outputs there go to the controller, as if that had asked. */
iso_control_answer iso_link_restore(iso_link *link, size_t bytes);

/* Ends the run: sends how it went. */
void iso_link_end(iso_link *link);

#endif
