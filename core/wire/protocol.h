/* The words, numbers and fields that must be the same at both ends of a wire, as tables. Programs of plants and tools
 * include them, and isoc writes the controller's end from them. So this file includes nothing.
 *
 * core/link/README.md has the frames, byte by byte; tests/core/link/controllers/test_frames.py compares its tables with
 * these. */
#ifndef ISO_CORE_WIRE_PROTOCOL_H
#define ISO_CORE_WIRE_PROTOCOL_H

/* --- How a run went ---------------------------------------------------------------------------------------------- */

/* The end of a run begins with the whole numbers of the statistics, in their order there, 64 bits each: the reader's
 * name and the member's name of each. margin has a sign. */
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
    X(near_singular_closure, near_singular_closure)                                                                    \
    X(events, events)                                                                                                  \
    X(late_events, late_events)

/* Then come these, 64 bits each: the reader's name, and the writer's value. */
#define ISO_STREAM_WORDS(X)                                                                                            \
    X(guard, loop->guard)                                                                                              \
    X(tick, loop->tick)                                                                                                \
    X(adams_restarts, adams->restarts)                                                                                 \
    X(substeps, adams->substeps)                                                                                       \
    X(rejected, adams->rejected)                                                                                       \
    X(budget_bound, adams->budget_bound)                                                                               \
    X(evaluations, adams->evaluations)                                                                                 \
    X(hash, hash)

/* The counts of a run on the wire: their names, in the order of the end frame. */
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

/* The types: those of the controller's frames, then of the plant's. The payload of each is ISO_LINK_NAME_FIELDS. */
#define ISO_LINK_TYPE_LIST(X)                                                                                          \
    X(HELLO, 'h')   /* asks who is there */                                                                            \
    X(START, 's')   /* a run from tick 0 */                                                                            \
    X(INPUTS, 'u')  /* those that answer the outputs of a tick */                                                      \
    X(END, 'e')     /* from the controller, without a payload: ends the run; from the plant: how it went */            \
    X(COMMAND, 'c') /* one of ISO_COMMAND_LIST */                                                                      \
    X(PLANT, 'H')   /* who is there */                                                                                 \
    X(OUTPUTS, 'y')                                                                                                    \
    X(ANSWER, 'C') /* to a command */                                                                                  \
    X(REFUSAL, 'n')

/* The fields of a payload, in their order: a name, a type, and how many there are; MANY are as many as the rest of
 * the frame has. REAL is as wide as the plant's. */
#define ISO_LINK_HELLO_FIELDS(X)
#define ISO_LINK_START_FIELDS(X)                                                                                       \
    X(identity, U64, 1) /* of the plant that the controller was made for */                                            \
    X(mode, U8, 1)                                                                                                     \
    X(ticks, U64, 1) /* 0: until it is ended */
#define ISO_LINK_INPUTS_FIELDS(X)                                                                                      \
    X(tick, U64, 1) /* of the outputs that they answer */                                                              \
    X(inputs, REAL, MANY)
#define ISO_LINK_END_FIELDS(X) X(words, U64, MANY) /* ISO_STREAM_COUNTS, ISO_STREAM_WORDS, ISO_LINK_COUNTS */
#define ISO_LINK_COMMAND_FIELDS(X)                                                                                     \
    X(command, U8, 1)                                                                                                  \
    X(number, U8, 1) /* of the controller's; then ISO_COMMAND_NAME_TAKES */
#define ISO_LINK_PLANT_FIELDS(X)                                                                                       \
    X(version, U8, 1)                                                                                                  \
    X(real_bytes, U8, 1)                                                                                               \
    X(wires, U16, 1)                                                                                                   \
    X(outputs, U16, 1)                                                                                                 \
    X(states, U16, 1)                                                                                                  \
    X(tunables, U16, 1)                                                                                                \
    X(identity, U64, 1)                                                                                                \
    X(period_ns, U32, 1)
#define ISO_LINK_OUTPUTS_FIELDS(X)                                                                                     \
    X(tick, U64, 1)                                                                                                    \
    X(outputs, REAL, MANY)
#define ISO_LINK_ANSWER_FIELDS(X)                                                                                      \
    X(command, U8, 1)                                                                                                  \
    X(number, U8, 1)                                                                                                   \
    X(answer, U8, 1) /* then as ISO_COMMAND_STATE_FIELDS, or the requested data */
#define ISO_LINK_REFUSAL_FIELDS(X)                                                                                     \
    X(reason, U8, 1)                                                                                                   \
    X(type, U8, 1) /* of the frame that is refused */

/* The bytes of all fields that stand once: 0 ISO_LINK_START_FIELDS(ISO_FIELD_BYTES). */
#define ISO_BYTES_OF_U8 1
#define ISO_BYTES_OF_U16 2
#define ISO_BYTES_OF_U32 4
#define ISO_BYTES_OF_U64 8
#define ISO_BYTES_IF_1(type) +ISO_BYTES_OF_##type
#define ISO_BYTES_IF_MANY(type)
#define ISO_FIELD_BYTES(name, type, count) ISO_BYTES_IF_##count(type)

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

/* The fields behind the number of each are ISO_COMMAND_NAME_TAKES. */
#define ISO_COMMAND_LIST(X)                                                                                            \
    X(STATE, 1)   /* how it is */                                                                                      \
    X(RUN, 2)     /* runs, then rests */                                                                               \
    X(REST, 3)    /* pauses */                                                                                         \
    X(RESET, 4)   /* a run from tick 0, in the mode of the last start; rests there */                                  \
    X(TAKE, 5)    /* takes a snapshot of the plant */                                                                  \
    X(READ, 6)    /* a piece of the snapshot */                                                                        \
    X(WRITE, 7)   /* a piece of it */                                                                                  \
    X(RESTORE, 8) /* puts the plant to the snapshot; rests there */                                                    \
    X(SET, 9)     /* a tunable, from the next step on */                                                               \
    X(GET, 10)    /* a tunable */                                                                                      \
    X(COUNTS, 11) /* how the run has gone so far */
#define ISO_COMMAND_STATE_TAKES(X)
#define ISO_COMMAND_RUN_TAKES(X) X(ticks, U64, 1) /* 0: without an end */
#define ISO_COMMAND_REST_TAKES(X)
#define ISO_COMMAND_RESET_TAKES(X)
#define ISO_COMMAND_TAKE_TAKES(X)
#define ISO_COMMAND_READ_TAKES(X) X(offset, U32, 1)
#define ISO_COMMAND_WRITE_TAKES(X) ISO_COMMAND_PIECE_FIELDS(X)
#define ISO_COMMAND_RESTORE_TAKES(X) X(bytes, U32, 1) /* of the snapshot */
#define ISO_COMMAND_SET_TAKES(X) ISO_COMMAND_VALUE_FIELDS(X)
#define ISO_COMMAND_GET_TAKES(X) X(tunable, U16, 1)
#define ISO_COMMAND_COUNTS_TAKES(X)

/* A piece of the snapshot, of at most so many bytes. All pieces are as long, but for the last one. */
enum { ISO_COMMAND_PIECE = 128 };
#define ISO_COMMAND_PIECE_FIELDS(X)                                                                                    \
    X(offset, U32, 1)                                                                                                  \
    X(piece, U8, MANY)

/* A tunable, by its place in the plant, and its value. */
#define ISO_COMMAND_VALUE_FIELDS(X)                                                                                    \
    X(tunable, U16, 1)                                                                                                 \
    X(value, REAL, MANY)

/* The answer to COUNTS has the words of an end frame, that to READ a piece, and that to GET a value; any other has the
 * state of the plant. */
#define ISO_COMMAND_STATE_FIELDS(X)                                                                                    \
    X(state, U8, 1)                                                                                                    \
    X(tick, U64, 1)                                                                                                    \
    X(left, U64, 1) /* ticks until it rests; all ones: without an end */                                               \
    X(hash, U64, 1) /* of the trajectory so far */                                                                     \
    X(snapshot_bytes, U32, 1)

/* The states of a plant. */
#define ISO_COMMAND_STATE_LIST(X)                                                                                      \
    X(NO_RUN, 0, "no run")                /* none has been started, or it is over */                                   \
    X(RUNS, 1, "runs")                    /* or waits for inputs, in lockstep */                                       \
    X(RESTS, 2, "rests")                  /* between two ticks */                                                      \
    X(STOPPED, 3, "stopped by the guard") /* until a reset, a restore or a start */

/* Why a snapshot is refused (core/runtime/snapshot.h), and the other reasons why a command is not carried out
 * (core/runtime/control.h): core/link/command.c compares the numbers with those. */
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
    X(ISO_CONTROL_RUNS, 19, "the plant does not rest")                                                                 \
    X(ISO_CONTROL_NO_TUNABLE, 20, "there is no such tunable")

#endif
