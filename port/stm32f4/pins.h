/* The pins of the STM32F4 in the table of pins (port/pins/pins.h): 16 for each letter, and the number, so that PA5 is 5
 * and PB0 is 16. Voltages in are those that have a converter; voltages out PA4 and PA5, duties out, of pulses of 20
 * kHz, PA6, PA7, PB0 and PB1. */
#ifndef ISO_PORT_STM32F4_PINS_H
#define ISO_PORT_STM32F4_PINS_H

#include "port/pins/pins.h"

enum { PINS_OF_A_PORT = 16 };

#endif
