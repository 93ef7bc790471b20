/* The rights of a master: the memory that it may read and write, and the resources that it may pause. An address is
 * the lower 32 bits of one of the processor's. */
#ifndef ISO_CORE_XCP_ACCESS_H
#define ISO_CORE_XCP_ACCESS_H

#include "core/runtime/admit.h"
#include "core/runtime/control.h"
#include "core/xcp/packet.h"

#define iso_xcp_write ISO_REAL_NAME(iso_xcp_write)

enum { ISO_XCP_SPANS = 10 };

/* Bytes that may be read. */
typedef struct iso_xcp_span {
    const void *start;
    uint32_t bytes;
} iso_xcp_span;

typedef struct iso_xcp_access {
    iso_xcp_span readable[ISO_XCP_SPANS]; /* those behind the last one have 0 bytes */
    real *tunables;                       /* [tunable_count], within a span: they may be written */
    const iso_limits *limits;             /* of each tunable; NULL where none has any */
    uint16_t tunable_count;
    real *inputs;                         /* [input_count]: they may be stimulated */
    uint16_t input_count;                 /* 0: none */
    uint32_t (*patience)(uint16_t input); /* how many steps a stimulus of one holds; 0: for ever; NULL: so do all */
    iso_control *control;                 /* NULL: it cannot be paused; else the snapshot there may be written */
    iso_control_answer (*take)(void);     /* takes a snapshot of the plant */
    iso_control_answer (*restore)(size_t bytes); /* puts the plant to that snapshot */
} iso_xcp_access;

static inline uint32_t iso_xcp_address(const void *const pointer)
{
    return (uint32_t)(uintptr_t)pointer;
}

/* Where these bytes are; NULL if one of them may not be read. */
const uint8_t *iso_xcp_at(const iso_xcp_access *access, uint32_t address, uint32_t count);

/* Sets tunables, or parts of them, to these bytes; all, or none where one is no tunable, or becomes a number that is
 * not finite or beyond its limits. A snapshot takes any bytes: they are checked when the plant is put to it. */
iso_xcp_error iso_xcp_write(const iso_xcp_access *access, uint32_t address, const uint8_t *bytes, uint32_t count);

#endif
