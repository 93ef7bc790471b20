/* Reads the stream of a run; core/application/stream.h has its format. */
#ifndef ISO_TOOLS_TRACE_STREAM_H
#define ISO_TOOLS_TRACE_STREAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "core/application/stream.h"
#include "core/runtime/policy.h"

enum { STREAM_TEXT_BYTES = 65536, STREAM_VALUES_MAX = 65535, STREAM_SNAPSHOT_MAX = 1 << 24 };

/* The content of the header. */
typedef struct stream_header {
    char scene[256];
    char method[16];
    char step[64];
    char real[16];
    char state_names[STREAM_TEXT_BYTES];   /* separated by commas; empty if unknown */
    char names[STREAM_TEXT_BYTES];         /* of the outputs */
    char closure_names[STREAM_TEXT_BYTES]; /* empty where nothing watches for singular positions */
    char units[STREAM_TEXT_BYTES];         /* as many; empty if unknown */
    double step_size;                      /* s */
    size_t real_bytes;                     /* 4 or 8 */
#define STREAM_HEADER_NUMBER(key, value) uint64_t key;
    ISO_STREAM_NUMBERS(STREAM_HEADER_NUMBER) /* duration_ns is 0 where there is no end */
} stream_header;

/* The content of the end. */
typedef struct stream_end {
#define STREAM_FIELD(name, value) uint64_t name;
    ISO_STREAM_COUNTS(STREAM_FIELD)
    ISO_STREAM_WORDS(STREAM_FIELD) /* guard: as many as there are states if none is bad */
} stream_end;

enum { STREAM_POLICY_WORDS = sizeof(iso_policy_histogram) / sizeof(uint64_t) };

/* The counts of policies, if there are any. */
typedef union stream_policy {
    iso_policy_histogram counted;
    uint64_t words[STREAM_POLICY_WORDS];
} stream_policy;

typedef struct stream {
    FILE *file;
    char error[STREAM_TEXT_BYTES]; /* why the last call failed */
    stream_header header;
    stream_end end;
    stream_policy policy;
    size_t policy_words;                 /* of it: none, those without a histogram, or all */
    uint64_t tick_min, tick_max, beside; /* counts, as in iso_times */
    uint64_t from;                       /* the tick of the first row */
    uint8_t *snapshot;                   /* [snapshot_bytes] that was taken; NULL if none was */
    size_t snapshot_bytes;
    uint8_t values[(STREAM_VALUES_MAX + 2) *
                   sizeof(double)]; /* of the last row, or the final state, local error, violation */
} stream;

typedef enum stream_part { STREAM_ROW, STREAM_END, STREAM_ERROR } stream_part;

/* Reads the header from run->file. False: run->error says why. */
bool stream_read_header(stream *run);

/* Reads the next part: a row into values, or the end into end and values. The tick where the run begins, and its
 * snapshot, are read on the way. */
stream_part stream_read(stream *run);

/* Name i of a list of the header, or an empty one; text[STREAM_TEXT_BYTES]. */
const char *stream_name(const char *names, size_t i, char *text);

/* Value i of values. */
double stream_number(const stream *run, size_t i);

/* The same as the shortest decimal that reads back; text[DECIMAL_BYTES]. */
const char *stream_value(const stream *run, size_t i, char *text);

#endif
