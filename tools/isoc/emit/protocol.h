/* The tables of core/application/protocol.h, as the other end of a wire has them. */
#ifndef ISOC_EMIT_PROTOCOL_H
#define ISOC_EMIT_PROTOCOL_H

#include "tools/isoc/base/text.h"

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

/* The rows of one, each as the pattern has it: a template with the places name, number and words. */
const char *protocol_rows(arena *memory, protocol_table table, const char *pattern);

/* The version of the frames, and the most bytes of a piece of a snapshot. */
const char *protocol_version(arena *memory);
const char *protocol_piece(arena *memory);

#endif
