/* The report of a fault, in place of the program's further output. */
#ifndef ISO_PORT_FAULT_H
#define ISO_PORT_FAULT_H

#include <stdint.h>

#include "port/port.h"

static inline void fault_write_word(const uint32_t word)
{
    char digits[8];
    for (unsigned i = 0; i < sizeof digits; i++) {
        digits[i] = "0123456789abcdef"[word >> (28 - 4 * i) & 0xF];
    }
    iso_port_write(digits, sizeof digits);
}

/* Writes why the processor stopped and, unless it is NULL, at which address; ends the program. */
static _Noreturn inline void fault_report(const uint32_t cause, const uint32_t *const place)
{
    static const char what[] = "Bail out! fault 0x";
    static const char where[] = " at 0x";
    iso_port_write(what, sizeof what - 1);
    fault_write_word(cause);
    if (place != NULL) {
        iso_port_write(where, sizeof where - 1);
        fault_write_word(*place);
    }
    iso_port_write("\n", 1);
    iso_port_exit(1);
}

#endif
