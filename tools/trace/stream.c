#include "tools/trace/stream.h"

#include <stdlib.h>
#include <string.h>

#include "core/application/stream.h"
#include "tools/trace/decimal.h"

static const char truncated[] = "the run broke off before its end";

static bool fail(stream *const run, const char *const message)
{
    snprintf(run->error, sizeof run->error, "%s", message);
    return false;
}

/* A line without its end. False at the end of the file, or if the line does not fit. */
static bool read_line(stream *const run, char *const line, const size_t bytes)
{
    if (fgets(line, (int)bytes, run->file) == NULL) {
        return fail(run, truncated);
    }
    char *const end = strchr(line, '\n');
    if (end == NULL) {
        return fail(run, feof(run->file) != 0 ? truncated : "a line of the header is too long");
    }
    *end = '\0';
    return true;
}

/* A whole number in hexadecimal. */
static bool parse_number(const char *const text, uint64_t *const number)
{
    char *end = NULL;
    *number = strtoull(text, &end, 16);
    return *text != '\0' && *end == '\0';
}

static bool parse_field(stream_header *const header, const char *const key, const char *const value)
{
#define STREAM_TEXT(name, unused)                                                                                      \
    if (strcmp(key, #name) == 0) {                                                                                     \
        return snprintf(header->name, sizeof header->name, "%s", value) < (int)sizeof header->name;                    \
    }
    ISO_STREAM_TEXTS(STREAM_TEXT)
#define STREAM_NUMBER(name, unused)                                                                                    \
    if (strcmp(key, #name) == 0) {                                                                                     \
        return parse_number(value, &header->name);                                                                     \
    }
    ISO_STREAM_NUMBERS(STREAM_NUMBER)
    return false;
}

static size_t commas(const char *text)
{
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += *text == ',';
    }
    return count;
}

static bool check_header(stream *const run)
{
    stream_header *const header = &run->header;
    header->real_bytes = strcmp(header->real, "float") == 0    ? sizeof(float)
                         : strcmp(header->real, "double") == 0 ? sizeof(double)
                                                               : 0;
    header->step_size = strtod(header->step, NULL);
    if (header->real_bytes == 0 || !(header->step_size > 0) || header->period_ns == 0 ||
        header->states > STREAM_VALUES_MAX || header->outputs > STREAM_VALUES_MAX ||
        (header->units[0] != '\0' && commas(header->units) != commas(header->names)) ||
        (header->state_names[0] != '\0' && commas(header->state_names) + 1 != header->states)) {
        return fail(run, "the header of the run makes no sense");
    }
    return true;
}

bool stream_read_header(stream *const run)
{
    static char line[STREAM_TEXT_BYTES];
    if (!read_line(run, line, sizeof line)) {
        return false;
    }
    if (line[0] == ISO_STREAM_BAIL_OUT) {
        return fail(run, line);
    }
    if (strcmp(line, ISO_STREAM_VERSION) != 0) {
        snprintf(run->error, sizeof run->error, "not a run: it begins with '%.60s'", line);
        return false;
    }
    while (read_line(run, line, sizeof line)) {
        if (line[0] == '\0') {
            return check_header(run);
        }
        char *const blank = strchr(line, ' ');
        if (blank == NULL) {
            return fail(run, "a line of the header has no value");
        }
        *blank = '\0';
        if (!parse_field(&run->header, line, blank + 1)) {
            snprintf(run->error, sizeof run->error, "the header's '%.60s' makes no sense", line);
            return false;
        }
    }
    return false;
}

/* A little-endian whole number. */
static uint64_t number_at(const uint8_t *const at, size_t bytes)
{
    uint64_t number = 0;
    while (bytes > 0) {
        number = number << 8 | at[--bytes];
    }
    return number;
}

/* Zero at the end of the file, which the caller tests for once, at the end. */
static uint64_t read_number(FILE *const file, const size_t bytes)
{
    uint8_t byte[sizeof(uint64_t)] = {0};
    (void)!fread(byte, 1, bytes, file);
    return number_at(byte, bytes);
}

static bool read_values(stream *const run, const uint64_t count)
{
    const size_t bytes = (size_t)count * run->header.real_bytes;
    return fread(run->values, 1, bytes, run->file) == bytes;
}

/* The rest of the stream. */
static bool read_policy(stream *const run)
{
    const size_t bytes = fread(run->policy.words, 1, sizeof run->policy, run->file);
    run->policy_words = bytes / sizeof(uint64_t);
    for (size_t i = 0; i < run->policy_words; i++) {
        run->policy.words[i] = number_at((const uint8_t *)&run->policy.words[i], sizeof(uint64_t));
    }
    return bytes == 0 || bytes == sizeof(iso_policy_counts) || bytes == sizeof(iso_policy_histogram);
}

static bool read_end(stream *const run)
{
    stream_end *const end = &run->end;
#define STREAM_READ(name, value) end->name = read_number(run->file, sizeof end->name);
    ISO_STREAM_COUNTS(STREAM_READ)
    ISO_STREAM_WORDS(STREAM_READ)
    return read_values(run, run->header.states + 2) && read_policy(run);
}

/* A snapshot; it replaces the one before, if there was one. */
static bool read_snapshot(stream *const run)
{
    const uint64_t bytes = read_number(run->file, sizeof bytes);
    free(run->snapshot);
    run->snapshot = bytes > STREAM_SNAPSHOT_MAX ? NULL : malloc(bytes + 1);
    run->snapshot_bytes = (size_t)bytes;
    return run->snapshot != NULL && fread(run->snapshot, 1, run->snapshot_bytes, run->file) == bytes;
}

/* The tag of the next part that is a row, an end, or none. */
static int read_tag(stream *const run)
{
    for (;;) {
        const int tag = fgetc(run->file);
        if (tag == ISO_STREAM_FROM) {
            run->from = read_number(run->file, sizeof run->from);
        } else if (tag == ISO_STREAM_TIMES) {
            run->tick_min = read_number(run->file, sizeof run->tick_min);
            run->tick_max = read_number(run->file, sizeof run->tick_max);
            run->beside = read_number(run->file, sizeof run->beside);
        } else if (tag != ISO_STREAM_SNAPSHOT || !read_snapshot(run)) {
            return tag;
        }
    }
}

stream_part stream_read(stream *const run)
{
    const int tag = read_tag(run);
    switch (tag) {
    case ISO_STREAM_ROW:
        if (read_values(run, run->header.outputs)) {
            return STREAM_ROW;
        }
        break;
    case ISO_STREAM_END:
        if (read_end(run)) {
            return STREAM_END;
        }
        break;
    case ISO_STREAM_BAIL_OUT:
        run->error[0] = ISO_STREAM_BAIL_OUT;
        (void)read_line(run, run->error + 1, sizeof run->error - 1);
        return STREAM_ERROR;
    case ISO_STREAM_SNAPSHOT:
    case EOF:
        break;
    default:
        fail(run, "the run's stream is damaged");
        return STREAM_ERROR;
    }
    fail(run, truncated);
    return STREAM_ERROR;
}

double stream_number(const stream *const run, const size_t i)
{
    const uint64_t bits = number_at(run->values + i * run->header.real_bytes, run->header.real_bytes);
    const uint32_t half = (uint32_t)bits;
    float narrow = 0;
    double wide = 0;
    memcpy(&narrow, &half, sizeof narrow);
    memcpy(&wide, &bits, sizeof wide);
    return run->header.real_bytes == sizeof narrow ? (double)narrow : wide;
}

const char *stream_value(const stream *const run, const size_t i, char *const text)
{
    return decimal_of(stream_number(run, i), run->header.real_bytes, text);
}

const char *stream_name(const char *names, const size_t i, char *const text)
{
    for (size_t before = 0; before < i && *names != '\0'; names++) {
        before += *names == ',';
    }
    snprintf(text, STREAM_TEXT_BYTES, "%.*s", (int)strcspn(names, ","), names);
    return text;
}
