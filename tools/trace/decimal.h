/* The shortest decimal number that reads back as the same bits. */
#ifndef ISO_TOOLS_TRACE_DECIMAL_H
#define ISO_TOOLS_TRACE_DECIMAL_H

#include <stddef.h>

enum { DECIMAL_BYTES = 32 };

/* Writes x, a number of so many bytes, with its final zero byte; returns text. A float is written short enough to read
 * back as a float. */
const char *decimal_of(double x, size_t bytes, char text[DECIMAL_BYTES]);

#endif
