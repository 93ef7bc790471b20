/* What stands at the pins of a simulated run: the script plays it, and pins.c measures it. Clocks count 8 ns, and see a
 * change at the first count behind it. */
#ifndef ISO_PORT_HOST_WIRES_H
#define ISO_PORT_HOST_WIRES_H

#include <stdbool.h>
#include <stdint.h>

enum { WIRES = 64, WIRES_CYCLE_NS = 8, WIRES_VOLTS_MOST = 4095 };

/* A change at a pin: to a level, or to a voltage by its code. */
typedef struct wires_change {
    unsigned pin;
    bool is_volts;
    uint64_t ns;
    uint32_t value;
} wires_change;

/* A pin at the last latch. */
typedef struct wire {
    bool is_high;
    uint32_t volts;
    uint64_t changed;      /* ns */
    uint64_t high, before; /* ns for which it was high until the last two latches */
    uint32_t rises;
    int32_t count; /* of the quadrature that begins at it */
} wire;

/* Takes a change of the script; false: it is earlier than the last one. */
bool wires_event(wires_change change);

/* Opens the file of what the pins show; false: that cannot be. */
bool wires_record(const char *path);

/* The period of the tick. */
void wires_period(uint32_t period_ns);

/* The time of a tick: all changes until then have happened. */
void wires_latch(uint64_t now);

/* At that latch. */
const wire *wires_at(unsigned pin);
uint64_t wires_now(void);
uint64_t wires_since(void);
uint32_t wires_period_cycles(void);

/* Writes what a pin shows, in the words of the script. */
void wires_show(const char *word, unsigned pin, uint64_t ns, const uint32_t *value);

#endif
