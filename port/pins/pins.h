/* The table of pins: which input of the plant a pin measures, and which output it shows; one format for every port that
 * has pins, this machine among them. A board has its own table: a file with PINS_INPUTS and PINS_OUTPUTS, rows between
 * commas, such as example.h, which CFLAGS='-include FILE' gives to the compiler. Without one nothing is measured and
 * nothing shown.
 *
 * A pin carries a number v, by its kind, and the plant has a value between at_0, where v is 0, and at_1, where v is 1,
 * or beyond:   value = at_0 + (at_1 - at_0) v. */
#ifndef ISO_PORT_PINS_PINS_H
#define ISO_PORT_PINS_PINS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numbers/real.h"

typedef enum pins_kind {
    PINS_VOLTAGE, /* v is the part of the supply, from 0 to 1 */
    PINS_DUTY,    /* v is the part of the time that the pin is high: in, of all since the tick before; out, of pulses */
    PINS_LEVEL,   /* v is 0 or 1; out, high from 0.5 on */
    PINS_EDGES,   /* in: v is the number of rising edges since the start */
    PINS_QUADRATURE, /* v is a count, up where this pin leads the next one; out, with an index on the third if `turn` is
                        not 0 */
    PINS_KINDS
} pins_kind;

typedef struct pins_row {
    size_t place; /* of the input or output in the scene, from 0 */
    pins_kind kind;
    unsigned pin; /* by its number on the board */
    real at_0, at_1;
    real safe;     /* of an output: v after the guard has stopped the plant, from 0 to 1; a count stays where it is */
    uint32_t turn; /* of PINS_QUADRATURE out: counts between two indices */
} pins_row;

/* The pins of a row, this one and those behind it. */
static inline unsigned pins_width(const pins_row *const row, const bool is_output)
{
    return row->kind != PINS_QUADRATURE ? 1 : is_output && row->turn > 0 ? 3 : 2;
}

/* --- What all boards share: table.h ------------------------------------------------------------------------------ */

/* The problem of a table; NULL: none. */
const char *pins_error(const pins_row *inputs, size_t input_count, const pins_row *outputs, size_t output_count);

/* Turns the pins of the table on, and returns NULL; or returns its problem. */
const char *pins_start(void);

/* Of iso_port_read, iso_port_publish and iso_port_safe. An input that is not measured keeps its last value. */
void pins_read(real *u, size_t count);
void pins_publish(const real *y, size_t count);
void pins_safe(void);

/* --- What a board has: its own file ------------------------------------------------------------------------------ */

/* Why a row cannot be; NULL: it can. */
const char *pins_lacks(const pins_row *row, bool is_output);

/* Why two rows cannot be together; NULL: they can. They have no pin in common. */
const char *pins_clash(const pins_row *a, bool a_is_output, const pins_row *b, bool b_is_output);

/* Turns a pin on: the row with that number of the inputs or the outputs. An output shows v = safe first. Returns NULL,
 * or why it cannot be, where that follows from all rows before. */
const char *pins_open(const pins_row *row, size_t number, bool is_output);

/* Measures v; whether there is one. */
bool pins_measure(const pins_row *row, size_t number, real *v);

/* Shows v, which is from 0 to 1 but for a count. */
void pins_show(const pins_row *row, size_t number, real v);

#endif
