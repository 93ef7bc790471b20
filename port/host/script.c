#include "port/host/script.h"

#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* More ticks than this last longer than the nanoseconds of 64 bits. */
#define TICKS_MAX (UINT64_MAX / 1000)

enum { EVENTS_MAX = 1024, LINE_MAX_BYTES = 256 };

typedef struct event {
    sim_kind kind;
    uint64_t tick;
    uint64_t ns;
} event;

static event events[EVENTS_MAX];
static size_t count;

static _Noreturn void fail(const char *const path, const unsigned line, const char *const message)
{
    fprintf(stderr, "%s:%u: %s\n", path, line, message);
    exit(EXIT_FAILURE);
}

/* A whole number up to max, with nothing but digits. */
static bool read_number(const char *const text, const uint64_t max, uint64_t *const value, const char **const end)
{
    char *stop = NULL;
    errno = 0;
    *value = strtoull(text, &stop, 10);
    *end = stop;
    return text[0] >= '0' && text[0] <= '9' && errno == 0 && *value <= max;
}

/* A duration such as 300us. An hour is more than any test needs, and keeps the sums of times far from overflow. */
static bool read_duration(const char *const text, uint64_t *const ns)
{
    static const struct {
        const char *name;
        uint64_t ns;
    } units[] = {{"ns", 1}, {"us", 1000}, {"ms", 1000000}, {"s", 1000000000}};
    const uint64_t hour = UINT64_C(3600000000000);
    const char *unit = NULL;
    if (!read_number(text, hour, ns, &unit)) {
        return false;
    }
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(unit, units[i].name) == 0) {
            const bool fits = *ns <= hour / units[i].ns;
            *ns *= fits ? units[i].ns : 0;
            return fits;
        }
    }
    return false;
}

static void read_line(char *const text, const char *const path, const unsigned line)
{
    static const char *const kinds[] = {[SIM_LATE] = "late", [SIM_LOSE] = "lose", [SIM_SLOW] = "slow"};
    const char *const blanks = " \t\r\n";
    text[strcspn(text, "#")] = '\0';
    const char *const verb = strtok(text, blanks);
    if (verb == NULL) {
        return;
    }
    unsigned kind = 0;
    while (kind < sizeof kinds / sizeof kinds[0] && strcmp(verb, kinds[kind]) != 0) {
        kind++;
    }
    if (kind == sizeof kinds / sizeof kinds[0]) {
        fail(path, line, "expected late, lose or slow");
    }
    const char *const tick_text = strtok(NULL, blanks);
    const char *end = "";
    uint64_t tick = 0;
    if (tick_text == NULL || !read_number(tick_text, TICKS_MAX, &tick, &end) || *end != '\0' || tick == 0) {
        fail(path, line, "expected the number of a tick, from 1 on");
    }
    uint64_t ns = 0;
    if (kind != SIM_LOSE) {
        const char *const duration = strtok(NULL, blanks);
        if (duration == NULL || !read_duration(duration, &ns)) {
            fail(path, line, "expected a duration of at most an hour, such as 300us (units: ns us ms s)");
        }
    }
    if (strtok(NULL, blanks) != NULL) {
        fail(path, line, "something follows the end of the event");
    }
    if (sim_script_has((sim_kind)kind, tick, NULL)) {
        fail(path, line, "the same event stands on a line before");
    }
    if (count == EVENTS_MAX) {
        fail(path, line, "too many events");
    }
    events[count++] = (event){.kind = (sim_kind)kind, .tick = tick, .ns = ns};
}

void sim_script_read(const char *const path)
{
    FILE *const file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        exit(EXIT_FAILURE);
    }
    char text[LINE_MAX_BYTES];
    unsigned line = 0;
    while (fgets(text, sizeof text, file) != NULL) {
        line++;
        if (strchr(text, '\n') == NULL && strlen(text) + 1 == sizeof text) {
            fail(path, line, "the line is too long");
        }
        read_line(text, path, line);
    }
    if (ferror(file) != 0) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        exit(EXIT_FAILURE);
    }
    fclose(file);
}

bool sim_script_has(const sim_kind kind, const uint64_t tick, uint64_t *const ns)
{
    for (size_t i = 0; i < count; i++) {
        if (events[i].kind == kind && events[i].tick == tick) {
            if (ns != NULL) {
                *ns = events[i].ns;
            }
            return true;
        }
    }
    return false;
}
