/* Writes the Test Anything Protocol on a port's console: no C library, no floating-point formatting, so that one test
 * program runs on the host and on every target. A program calls the checks in turn and ends with tap_done(), which
 * prints the plan: one that dies on the way has no plan and counts as failed.
 */
#ifndef ISO_TESTS_TAP_H
#define ISO_TESTS_TAP_H

#include <stdbool.h>
#include <stdint.h>

#include "core/numbers/real.h"

/* One test: passed or not. */
void tap_ok(bool passed, const char *name);

/* One test: got equals want; a failure shows both, in decimal or (tap_bits) in hex. */
void tap_count(uint32_t got, uint32_t want, const char *name);
void tap_bits(uint64_t got, uint64_t want, const char *name);

/* A comment line "# name value" beside the results. */
void tap_note(const char *name, uint32_t value);
void tap_note_bits(const char *name, uint64_t value);

/* Prints the plan and ends the program: status 0 if every test passed. */
_Noreturn void tap_done(void);

/* One test: the two reals have the same bits. */
static inline void tap_same(const real got, const real want, const char *const name)
{
    tap_bits(iso_bits_of(got), iso_bits_of(want), name);
}

#endif
