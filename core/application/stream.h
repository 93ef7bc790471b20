/* The run as a stream of bytes on the console, for build/trace to write down: nothing here formats a number in decimal.
 *
 *     header   lines "key value", the first "isochron 2", then an empty line; whole numbers in hexadecimal
 *     from     ISO_STREAM_FROM, the tick that the first row is of, 64 bits; without it that is 0
 *     row      ISO_STREAM_ROW, the outputs of a tick; the first are those of tick 0, the start
 *     snapshot ISO_STREAM_SNAPSHOT, its size, 64 bits, and its bytes (core/runtime/snapshot.h): of the last row's tick
 *     times    ISO_STREAM_TIMES, the least and the most that a whole tick took, and all that was beside, 64 bits each
 *     end      ISO_STREAM_END, the statistics, the hash, the guard, the state, the largest local error and violation;
 *              then the counts of the policies (core/runtime/policy.h), if the scene has some, to the end of the stream
 *
 * All numbers are little-endian, reals as wide as the build's. A program or port that gives up writes a line of text
 * that starts with ISO_STREAM_BAIL_OUT in place of one of these parts.
 */
#ifndef ISO_CORE_APPLICATION_STREAM_H
#define ISO_CORE_APPLICATION_STREAM_H

#include "core/application/times.h"
#include "core/runtime/loop.h"
#include "core/wire/protocol.h"

#define iso_stream_header ISO_REAL_NAME(iso_stream_header)
#define iso_stream_give_up ISO_REAL_NAME(iso_stream_give_up)
#define iso_stream_from ISO_REAL_NAME(iso_stream_from)
#define iso_stream_snapshot ISO_REAL_NAME(iso_stream_snapshot)
#define iso_stream_times ISO_REAL_NAME(iso_stream_times)
#define iso_stream_row ISO_REAL_NAME(iso_stream_row)
#define iso_stream_end ISO_REAL_NAME(iso_stream_end)

#define ISO_STREAM_VERSION "isochron 2"

enum {
    ISO_STREAM_FROM = 'f',
    ISO_STREAM_ROW = 'r',
    ISO_STREAM_SNAPSHOT = 's',
    ISO_STREAM_TIMES = 't',
    ISO_STREAM_END = 'e',
    ISO_STREAM_BAIL_OUT = 'B'
};

/* The lines of the header: their keys, by which the reader knows them, and their values; an unknown text is NULL. */
#define ISO_STREAM_TEXTS(X)                                                                                            \
    X(scene, model->name)                                                                                              \
    X(method, model->method)                                                                                           \
    X(step, model->step_text)                                                                                          \
    X(real, sizeof(real) == sizeof(float) ? "float" : "double")                                                        \
    X(state_names, model->state_names)                                                                                 \
    X(names, model->output_names)                                                                                      \
    X(closure_names, model->closure_names)                                                                             \
    X(units, model->output_units)
#define ISO_STREAM_NUMBERS(X)                                                                                          \
    X(period_ns, model->period_ns)                                                                                     \
    X(duration_ns, duration)                                                                                           \
    X(states, model->states)                                                                                           \
    X(outputs, model->outputs)

/* Writes, in place of a run, the reason why there is none. Ends the program. */
_Noreturn void iso_stream_give_up(const char *why);

/* The header of the run: the plant, and the plant time to run in nanoseconds. */
void iso_stream_header(const iso_plant *plant, uint64_t duration);

/* The outputs y[outputs] of tick 0, then of each tick that is done. */
void iso_stream_row(const real *y, size_t outputs);

/* Of a run that begins at a snapshot: the tick of the snapshot, before the first row. */
void iso_stream_from(uint64_t tick);

/* A snapshot that was taken: behind the row of its tick. */
void iso_stream_snapshot(const unsigned char *snapshot, size_t bytes);

/* The times of the ticks, and of the work beside them. */
void iso_stream_times(const iso_times *times);

/* Ends the stream: how the loop kept its time, where it stopped, and the hash of the trajectory. */
void iso_stream_end(const iso_loop *loop, uint64_t hash);

#endif
