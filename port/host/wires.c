#include "port/host/wires.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static wires_change *changes;
static size_t change_count, change_room, played;
static wire wires[WIRES];
static uint64_t latched, latched_before;
static uint32_t tick_ns;
static FILE *record;

bool wires_event(const wires_change change)
{
    if (change_count > 0 && change.ns < changes[change_count - 1].ns) {
        return false;
    }
    if (change_count == change_room) {
        change_room = 2 * change_room + 1024;
        wires_change *const more = realloc(changes, change_room * sizeof changes[0]);
        if (more == NULL) {
            fprintf(stderr, "no memory for a script of %zu lines\n", change_count);
            exit(EXIT_FAILURE);
        }
        changes = more;
    }
    changes[change_count] = change;
    changes[change_count].ns = (change.ns + WIRES_CYCLE_NS - 1) / WIRES_CYCLE_NS * WIRES_CYCLE_NS;
    change_count++;
    return true;
}

bool wires_record(const char *const path)
{
    if (record == NULL) {
        record = fopen(path, "w");
    }
    return record != NULL;
}

void wires_period(const uint32_t period_ns)
{
    tick_ns = period_ns;
}

/* How far a quadrature turns when a pin of it changes: 1 or -1 count. A leads B upwards. */
static int32_t turned(const bool a_before, const bool b_before, const bool a, const bool b)
{
    static const int32_t places[2][2] = {{0, 3}, {1, 2}};
    const int32_t turn = (places[a][b] - places[a_before][b_before]) & 3;
    return turn == 3 ? -1 : turn == 1;
}

static void change_level(const wires_change *const change)
{
    wire *const w = &wires[change->pin];
    const bool is_high = change->value != 0, was_high = w->is_high;
    w->high += was_high ? change->ns - w->changed : 0;
    w->changed = change->ns;
    w->rises += is_high && !was_high;
    w->is_high = is_high;
    if (change->pin + 1 < WIRES) {
        const bool b = wires[change->pin + 1].is_high;
        w->count += turned(was_high, b, is_high, b);
    }
    if (change->pin > 0) {
        const bool a = wires[change->pin - 1].is_high;
        wires[change->pin - 1].count += turned(a, was_high, a, is_high);
    }
}

void wires_latch(const uint64_t now)
{
    latched_before = latched;
    latched = now;
    for (unsigned pin = 0; pin < WIRES; pin++) {
        wires[pin].before = wires[pin].high;
    }
    for (; played < change_count && changes[played].ns <= now; played++) {
        if (changes[played].is_volts) {
            wires[changes[played].pin].volts = changes[played].value;
        } else {
            change_level(&changes[played]);
        }
    }
    for (unsigned pin = 0; pin < WIRES; pin++) {
        wire *const w = &wires[pin];
        w->high += w->is_high ? now - w->changed : 0;
        w->changed = now;
    }
}

const wire *wires_at(const unsigned pin)
{
    return &wires[pin];
}

uint64_t wires_now(void)
{
    return latched;
}

uint64_t wires_since(void)
{
    return latched - latched_before;
}

uint32_t wires_period_cycles(void)
{
    return tick_ns / WIRES_CYCLE_NS;
}

void wires_show(const char *const word, const unsigned pin, const uint64_t ns, const uint32_t *const value)
{
    if (record != NULL) {
        fprintf(record, "%s %u %" PRIu64 "ns", word, pin, ns);
        if (value != NULL) {
            fprintf(record, " %" PRIu32, *value);
        }
        fputc('\n', record);
    }
}
