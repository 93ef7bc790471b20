/* What the two ends of a wire must have alike, as tables. The programs of plants are made of them, and the tools; isoc writes
 * the controller's end from them. So nothing is included here.
 *
 * core/link/README.md has the frames, byte by byte. */
#ifndef ISO_CORE_APPLICATION_PROTOCOL_H
#define ISO_CORE_APPLICATION_PROTOCOL_H

/* --- How a run went ---------------------------------------------------------------------------------------------- */

/* The end record begins with the whole numbers of the statistics, in their order there, 64 bits each: what the reader
 * calls them, and what they are called there. margin has a sign. */
#define ISO_STREAM_COUNTS(X)                                                                                           \
    X(ticks, ticks)                                                                                                    \
    X(late, late)                                                                                                      \
    X(lost, lost)                                                                                                      \
    X(overruns, overruns)                                                                                              \
    X(restarts, restarts)                                                                                              \
    X(violated, violated)                                                                                              \
    X(margin, margin)                                                                                                  \
    X(execution_min, execution_min)                                                                                    \
    X(execution_max, execution_max)                                                                                    \
    X(execution_sum, execution_sum)                                                                                    \
    X(restart_max, restart_max)                                                                                        \
    X(inputs_held, inputs.held)                                                                                        \
    X(inputs_clamped, inputs.clamped)                                                                                  \
    X(tunables_held, parameters.held)                                                                                  \
    X(tunables_clamped, parameters.clamped)                                                                            \
    X(outputs_held, outputs_held)                                                                                      \
    X(near_singular, near_singular)                                                                                    \
    X(near_singular_first, near_singular_first)                                                                        \
    X(near_singular_closure, near_singular_closure)

/* Then come these, 64 bits each: what the reader calls them, and what the writer puts there. */
#define ISO_STREAM_WORDS(X)                                                                                            \
    X(guard, loop->guard)                                                                                              \
    X(tick, loop->tick)                                                                                                \
    X(adams_restarts, adams->restarts)                                                                                 \
    X(substeps, adams->substeps)                                                                                       \
    X(rejected, adams->rejected)                                                                                       \
    X(budget_bound, adams->budget_bound)                                                                               \
    X(evaluations, adams->evaluations)                                                                                 \
    X(hash, hash)

/* How a run went on the wire: what each is called, in the order of the end frame. */
#define ISO_LINK_COUNTS(X)                                                                                             \
    X(inputs)   /* frames of inputs whose values were taken */                                                         \
    X(late)     /* of them, those that answer an earlier tick than the last */                                         \
    X(repeated) /* frames that answer the same tick as the newest before; not taken */                                 \
    X(stale)    /* frames that answer an earlier tick than that, or one that has not been; not taken */                \
    X(missing)  /* ticks of a free run for which no values came: the last ones held */                                 \
    X(safe)     /* of them, those in which an input had become its safe value */                                       \
    X(damaged)  /* pieces between zeros that are no frame */                                                           \
    X(refused)  /* frames that were refused */                                                                         \
    X(unsent)   /* frames that the channel had no room for */

/* --- Frames ------------------------------------------------------------------------------------------------------ */

enum { ISO_LINK_VERSION = 1 };

/* The types: what the controller sends, then what the plant sends. */
#define ISO_LINK_TYPE_LIST(X)                                                                                          \
    X(HELLO, 'h')   /* asks who is there */                                                                            \
    X(START, 's')   /* a run from tick 0: ISO_LINK_START_FIELDS */                                                     \
    X(INPUTS, 'u')  /* u64 tick of the outputs that they answer, reals of the wires */                                 \
    X(END, 'e')     /* from the controller: ends the run; from the plant: how it went, 64 bits each */                 \
    X(COMMAND, 'c') /* what else can be asked of a plant: ISO_COMMAND_LIST */                                          \
    X(PLANT, 'H')   /* u8 version, bytes of a real, u16 wires, outputs, states, tunables, u64 identity, u32 period */  \
    X(OUTPUTS, 'y') /* u64 tick, reals of the outputs */                                                               \
    X(ANSWER, 'C')  /* to a command: u8 command, its number, answer; then ISO_COMMAND_STATE_FIELDS, or a piece */      \
    X(REFUSAL, 'n') /* u8 reason, type of the frame that is refused */

/* The fields of a start, and their bytes. */
#define ISO_LINK_START_FIELDS(X)                                                                                       \
    X(identity, 8) /* of the plant that the controller was made for */                                                 \
    X(mode, 1)                                                                                                         \
    X(ticks, 8) /* 0: until it is ended */

/* The modes of a run. */
#define ISO_LINK_MODE_LIST(X)                                                                                          \
    X(FREE, 0, "free")                                                                                                 \
    X(LOCKSTEP, 1, "lockstep")

/* Why a frame is refused. */
#define ISO_LINK_REASON_LIST(X)                                                                                        \
    X(UNKNOWN, 1, "a frame of this type or length is not known")                                                       \
    X(FOREIGN, 2, "another plant, method, step or type of numbers: make the controller again")                         \
    X(NO_MODE, 3, "there is no such mode")                                                                             \
    X(NOT_STARTED, 4, "no run has been started")                                                                       \
    X(ALREADY_STARTED, 5, "the program makes one run, and it has begun")

/* --- Commands ---------------------------------------------------------------------------------------------------- */

/* Each is a byte, followed by its number, a byte, and by this. */
#define ISO_COMMAND_LIST(X)                                                                                            \
    X(STATE, 1)   /* : how it is */                                                                                    \
    X(RUN, 2)     /* u64 ticks, 0 without an end: runs, then rests */                                                  \
    X(REST, 3)    /* : pauses */                                                                                       \
    X(RESET, 4)   /* : a run from tick 0, in the mode of the last start; rests there */                                \
    X(TAKE, 5)    /* : takes a snapshot into the record */                                                             \
    X(READ, 6)    /* u32 offset: a piece of the record */                                                              \
    X(WRITE, 7)   /* u32 offset, the bytes of a piece */                                                               \
    X(RESTORE, 8) /* u32 bytes of the record: puts the plant to it; rests there */

/* The most bytes of a piece. All pieces of a record are as long, but for the last one. */
enum { ISO_COMMAND_PIECE = 128 };

/* The fields of an answer that is no piece, and their bytes. */
#define ISO_COMMAND_STATE_FIELDS(X)                                                                                    \
    X(state, 1)                                                                                                        \
    X(tick, 8)                                                                                                         \
    X(left, 8) /* ticks until it rests; all ones: without an end */                                                    \
    X(hash, 8) /* of the trajectory so far */                                                                          \
    X(snapshot_bytes, 4)

/* How a plant is. */
#define ISO_COMMAND_STATE_LIST(X)                                                                                      \
    X(NO_RUN, 0, "no run")                /* none has been started, or it is over */                                   \
    X(RUNS, 1, "runs")                    /* or waits for inputs, in lockstep */                                       \
    X(RESTS, 2, "rests")                  /* between two ticks */                                                      \
    X(STOPPED, 3, "stopped by the guard") /* until a reset, a restore or a start */

/* Why a snapshot is refused (core/runtime/snapshot.h), and what else was not done (core/runtime/control.h): core/link/command.c
 * compares the numbers with those. */
#define ISO_SNAPSHOT_REFUSALS(X)                                                                                       \
    X(ISO_SNAPSHOT_NO_SNAPSHOT, 1, "this is no snapshot")                                                              \
    X(ISO_SNAPSHOT_OTHER_VERSION, 2, "the snapshot is of another version")                                             \
    X(ISO_SNAPSHOT_WRONG_SIZE, 3, "the snapshot is not whole")                                                         \
    X(ISO_SNAPSHOT_DAMAGED, 4, "the snapshot is damaged")                                                              \
    X(ISO_SNAPSHOT_OTHER_NUMBERS, 5, "the snapshot has another type of numbers")                                       \
    X(ISO_SNAPSHOT_OTHER_PLANT, 6, "the snapshot is of another plant, method or step")                                 \
    X(ISO_SNAPSHOT_NOT_A_STATE, 7, "the snapshot has a number that no plant has")
#define ISO_CONTROL_REFUSALS(X)                                                                                        \
    X(ISO_CONTROL_NO_RUN, 16, "there is no run")                                                                       \
    X(ISO_CONTROL_BAD_STATE, 17, "the guard has stopped the plant")                                                    \
    X(ISO_CONTROL_BEYOND, 18, "a piece beyond the end")                                                                \
    X(ISO_CONTROL_RUNS, 19, "the plant does not rest")

#endif
