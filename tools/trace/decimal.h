/* The shortest decimal number that reads back as the same bits. */
#ifndef ISO_TOOLS_TRACE_DECIMAL_H
#define ISO_TOOLS_TRACE_DECIMAL_H

enum { DECIMAL_BYTES = 32 };

/* Writes x with its final zero byte; returns text. A float is written short enough to read back as a float. */
const char *decimal_of_double(double x, char text[DECIMAL_BYTES]);
const char *decimal_of_float(float x, char text[DECIMAL_BYTES]);

#endif
