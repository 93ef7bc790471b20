#include "port/host/script.h"

#include "port/host/wires.h"

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

/* high PIN TIME, low PIN TIME, volts PIN TIME CODE, record FILE: whether it is one of them, whose first word was read.
 */
static bool read_pin(const char *const verb, const char *const path, const unsigned line)
{
    const char *const blanks = " \t\r\n";
    const bool is_volts = strcmp(verb, "volts") == 0, is_high = strcmp(verb, "high") == 0;
    if (strcmp(verb, "record") == 0) {
        const char *const file = strtok(NULL, blanks);
        if (file == NULL || !wires_record(file)) {
            fail(path, line, "expected a file that can be written");
        }
        return true;
    }
    if (!is_volts && !is_high && strcmp(verb, "low") != 0) {
        return false;
    }
    const char *const pin_text = strtok(NULL, blanks), *const time_text = strtok(NULL, blanks);
    const char *end = "";
    uint64_t pin = 0, ns = 0, code = is_high;
    if (pin_text == NULL || !read_number(pin_text, WIRES - 1, &pin, &end) || *end != '\0') {
        fail(path, line, "expected the number of a pin, from 0 to 63");
    }
    if (time_text == NULL || !read_duration(time_text, &ns)) {
        fail(path, line, "expected a time of at most an hour, such as 300us (units: ns us ms s)");
    }
    if (is_volts) {
        const char *const code_text = strtok(NULL, blanks);
        if (code_text == NULL || !read_number(code_text, WIRES_VOLTS_MOST, &code, &end) || *end != '\0') {
            fail(path, line, "expected what the converter makes of the voltage, from 0 to 4095");
        }
    }
    if (!wires_event((wires_change){.pin = (unsigned)pin, .ns = ns, .is_volts = is_volts, .value = (uint32_t)code})) {
        fail(path, line, "it stands before the line above in time");
    }
    return true;
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
    if (read_pin(verb, path, line)) {
        if (strtok(NULL, blanks) != NULL) {
            fail(path, line, "something follows the end of the line");
        }
        return;
    }
    unsigned kind = 0;
    while (kind < sizeof kinds / sizeof kinds[0] && strcmp(verb, kinds[kind]) != 0) {
        kind++;
    }
    if (kind == sizeof kinds / sizeof kinds[0]) {
        fail(path, line, "expected late, lose, slow, high, low, volts or record");
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
