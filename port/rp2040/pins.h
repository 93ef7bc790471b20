/* What the tick and the start do for the pins. */
#ifndef ISO_PORT_RP2040_PINS_H
#define ISO_PORT_RP2040_PINS_H

#include "port/pins/pins.h"

/* With the period of the tick, before the first one: NULL, or why the table cannot be. */
const char *pins_begin(uint32_t period_cycles);

/* In the interrupt of a tick, with the cycles at which it was due, modulo 2^32. */
void pins_latch(uint32_t tick_cycles);

#endif
