/* Measurement and calibration: what core/xcp is told of the plant, and what its tools are told, the A2L. */
#ifndef ISOC_EMIT_A2L_H
#define ISOC_EMIT_A2L_H

#include <stdint.h>

#include "tools/isoc/emit/naming.h"

/* The interface of a plant for core/xcp: iso_xcp_the_description, and `services`. The lock is the name of an
 * iso_xcp_lock, or "open". */
void emit_calibration(const plant *p, const naming *names, const char *lock, uint64_t identity, text *out);

/* The A2L without the addresses, which a linker gives: where it has @SYMBOL+OFFSET@, tools/a2l/a2l.sh puts a number, and
 * for lines of `@statistics@` and `@names of statistics@` what tools/a2l/places.c has. ASAP2, version 1.61. */
void emit_a2l(const plant *p, const naming *names, uint64_t identity, text *out);

#endif
