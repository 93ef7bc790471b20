/* The table of pins: which input of the plant a pin measures, and which output it shows. The numbers of inputs and
 * outputs are their places in the scene. A board has its own table: a file with PINS_INPUTS and PINS_OUTPUTS, such as
 * pins_example.h, which CFLAGS='-include FILE' gives to the compiler. Without one the board measures and shows nothing.
 */
#ifndef ISO_PORT_STM32F4_PINS_H
#define ISO_PORT_STM32F4_PINS_H

#include <stddef.h>

#include "core/numbers/real.h"
#include "port/stm32f4/adc.h"

/* u[input] = at_0 + (at_full - at_0) v, with v from 0 at 0 V to 1 at the supply. */
typedef struct pins_input {
    size_t input;
    char port;
    unsigned pin;
    real at_0, at_full;
} pins_input;

/* A voltage on PA4 or PA5, or the width of pulses of 20 kHz on PA6, PA7, PB0 or PB1: 0 where y[output] is at_0, all
 * where it is at_full, and in between in proportion; `safe` of all, from 0 to 1, after the guard has stopped the plant.
 */
typedef struct pins_output {
    size_t output;
    char port;
    unsigned pin;
    real at_0, at_full, safe;
} pins_output;

/* 0 and 1: the converter to voltages; 2 to 5: pulse widths; -1: a pin that shows nothing. */
static inline int pins_channel(const char port, const unsigned pin)
{
    return port == 'A' && pin >= 4 && pin < 8 ? (int)pin - 4 : port == 'B' && pin < 2 ? 4 + (int)pin : -1;
}

/* The problem of a table; NULL: none. */
const char *pins_error(const pins_input *inputs, size_t input_count, const pins_output *outputs, size_t output_count);

/* Turns the pins on, and returns NULL; or returns the problem of the table. */
const char *pins_start(void);

#endif
