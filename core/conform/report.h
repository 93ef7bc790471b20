/* Lines on the console, one for each duty of a port: "DUTY ok: OBSERVATION", "DUTY FAILED: OBSERVATION" or "DUTY has
 * none: REASON". */
#ifndef ISO_CORE_CONFORM_REPORT_H
#define ISO_CORE_CONFORM_REPORT_H

#include <stdbool.h>
#include <stdint.h>

#include "port/port.h"

static inline void conform_text(const char *const text)
{
    size_t length = 0;
    while (text[length] != '\0') {
        length++;
    }
    iso_port_write(text, length);
}

static inline void conform_number(uint64_t number)
{
    char digits[20];
    size_t first = sizeof digits;
    do {
        digits[--first] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    iso_port_write(digits + first, sizeof digits - first);
}

static inline void conform_begin(const char *const duty, const bool good)
{
    conform_text(duty);
    conform_text(good ? " ok: " : " FAILED: ");
}

/* A whole line: numbers stand before the texts that name them. */
static inline bool conform_line(const char *const duty, const bool good, const uint64_t number, const char *const what)
{
    conform_begin(duty, good);
    conform_number(number);
    conform_text(what);
    conform_text("\n");
    return good;
}

/* Whether the port's channel for a controller returns each byte; true where it has none. In channel.c or no_channel.c.
 */
bool conform_channel(void);

#endif
