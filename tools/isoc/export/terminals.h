/* Shared by the files that write what speaks with a plant: a controller at the other end of a wire, a program that has
 * the plant in it, tools of measurement and calibration. */
#ifndef ISOC_EXPORT_TERMINALS_H
#define ISOC_EXPORT_TERMINALS_H

#include "tools/isoc/emit/parts.h"
#include "tools/isoc/export/export.h"

/* a2l.c: measurement and calibration: the tables of core/xcp for the plant, and the description for its tools, the A2L.
 */

/* The interface of a plant for core/xcp: iso_xcp_the_description, and `services`. The lock is the name of an
 * iso_xcp_lock, or "open". */
void emit_calibration(const plant *p, const naming *names, const char *lock, const char *identity, text *out);

/* Adds plant.a2l.in, the A2L without the addresses, which a linker gives: where it has @SYMBOL+OFFSET@,
 * tools/lab/a2l.py puts a number, and for lines of `@statistics@` and `@names of statistics@` the rows of
 * tools/a2l/places.c. ASAP2, version 1.61. */
void emit_a2l(const plant *p, const naming *names, const char *identity, file_list *files);

/* protocol.c: the tables of core/wire/protocol.h, as the other end of a wire has them. */

typedef enum protocol_table {
    PROTOCOL_WORDS,
    PROTOCOL_FRAMES,
    PROTOCOL_START_FIELDS,
    PROTOCOL_MODES,
    PROTOCOL_REASONS,
    PROTOCOL_COMMANDS,
    PROTOCOL_STATE_FIELDS,
    PROTOCOL_STATES,
    PROTOCOL_ANSWERS,
    PROTOCOL_TABLES
} protocol_table;

/* All of them as ISO_CLIENT_WORDS(X) and so on, with the numbers below. */
const char *protocol_in_c(arena *memory);

/* The rows of one, each as the pattern has it: a template with the places name, number, words, layout and bytes. */
const char *protocol_rows(arena *memory, protocol_table table, const char *pattern);

/* terminals.c: inputs, outputs and tunables of a plant as a controller at the other end of a wire sees them, and a
 * program of another language that has the plant in it. */

/* The inputs are those that come in from outside: the wires. */
typedef struct terminals {
    const char *prefix, *capitals; /* of names in C: cart_pole, CART_POLE */
    const char *scene;
    quantities inputs, outputs, tunables;
    const char *identity; /* 16 digits */
    long period_ns;
    bool is_double;
} terminals;

/* The identity of the plant follows from its header and its source, the first two of the files, and from its wires. */
terminals terminals_of(const plant *p, const naming *names, const file_list *files);

/* The wires as C: the inputs that come over the link, with their safe values. */
void emit_wires(const plant *p, const naming *names, text *out);

/* The identity of the first files of a list, and of a text more: 16 digits. */
const char *identity_of(const file_list *files, size_t count, const text *more);

/* A number of a range as C or Python has it; none is `infinity`. */
const char *bound(arena *memory, double number, const char *infinity);

/* python.c: adds the controller's end in Python, a module that is a package too. */
void add_python_of_link(const terminals *t, file_list *files);

#endif
