/* Commands over the link: a controller asks the plant to run, to rest, to begin anew, and for its snapshot. They are
 * done between two ticks. core/link/README.md has their frames, byte by byte.
 *
 * A command has a number of the controller's. The same command with the same number once more is one whose answer was
 * lost: it is answered again and not done again, unless it can be done twice. */
#ifndef ISO_CORE_LINK_COMMAND_H
#define ISO_CORE_LINK_COMMAND_H

#include "core/link/frame.h"
#include "core/runtime/control.h"
#include "core/wire/protocol.h"

#define iso_command_do ISO_REAL_NAME(iso_command_do)
#define iso_command_restore ISO_REAL_NAME(iso_command_restore)
#define iso_command_put_answer ISO_REAL_NAME(iso_command_put_answer)
#define iso_command_put_counts ISO_REAL_NAME(iso_command_put_counts)

/* As the tables of core/wire/protocol.h have them. */
#define ISO_COMMAND_TYPE_CONSTANT(name, number) ISO_COMMAND_##name = (number),
typedef enum iso_command_type { ISO_COMMAND_LIST(ISO_COMMAND_TYPE_CONSTANT) ISO_COMMANDS } iso_command_type;

/* Bytes of the payload of the longest answer. */
enum {
    ISO_COMMAND_ANSWER_BYTES =
        0 ISO_LINK_ANSWER_FIELDS(ISO_FIELD_BYTES) ISO_COMMAND_PIECE_FIELDS(ISO_FIELD_BYTES) + ISO_COMMAND_PIECE
};

/* How a run went on the wire. */
#define ISO_LINK_MEMBER(name) uint64_t name;
typedef struct iso_link_statistics {
    ISO_LINK_COUNTS(ISO_LINK_MEMBER)
} iso_link_statistics;

/* Words of 64 bits in an end frame: the statistics of the loop, the words behind them in the stream of a run, guard and
 * hash among them, and the statistics of the link. */
#define ISO_LINK_ONE_OF(...) +1
enum {
    ISO_LINK_END_WORDS =
        0 ISO_STREAM_COUNTS(ISO_LINK_ONE_OF) ISO_STREAM_WORDS(ISO_LINK_ONE_OF) ISO_LINK_COUNTS(ISO_LINK_ONE_OF)
};

/* How a plant is. */
#define ISO_COMMAND_STATE_CONSTANT(name, number, words) ISO_COMMAND_##name = (number),
typedef enum iso_command_state { ISO_COMMAND_STATE_LIST(ISO_COMMAND_STATE_CONSTANT) } iso_command_state;

/* The last command. */
typedef struct iso_commands {
    uint64_t done;    /* commands */
    uint64_t refused; /* commands */
    uint8_t type;     /* 0: there was none */
    uint8_t number;
    uint8_t answer; /* iso_control_answer */
} iso_commands;

/* The outcome of a command. */
typedef enum iso_command_outcome {
    ISO_COMMAND_UNKNOWN, /* no such command, or of another length; all others have an answer */
    ISO_COMMAND_DONE,    /* done, or refused */
    ISO_COMMAND_MOVED,   /* a repeated one: the plant was put to another tick before */
    ISO_COMMAND_WENT_ON, /* the plant rests at another tick; a run that the guard had stopped goes on */
    ISO_COMMAND_ANEW     /* the plant rests at tick 0 of a new run */
} iso_command_outcome;

/* Carries out the command of a payload. is_running: there is a run, which has not ended. */
iso_command_outcome iso_command_do(iso_commands *commands, iso_control *control, bool is_running,
                                   const uint8_t *payload, size_t length);

/* Puts the plant to the snapshot of the control: while there is a run, or where the guard has stopped it. */
iso_control_answer iso_command_restore(iso_control *control, bool is_running, size_t bytes);

/* Writes the payload of the answer to it; `wire`: how the run has gone there so far. */
void iso_command_put_answer(const iso_commands *commands, const iso_control *control, const iso_link_statistics *wire,
                            bool is_running, const uint8_t *payload, iso_frame_writer *w);

/* Writes the words of an end frame: how the run went, or has gone so far. */
void iso_command_put_counts(const iso_control *control, const iso_link_statistics *wire, iso_frame_writer *w);

#endif
