/* The interface of a plant to the programs at the other end of its link. isoc writes it beside the plant
 * (interface.c); the program of a plant without a link has none of it. */
#ifndef ISO_CORE_LINK_INTERFACE_H
#define ISO_CORE_LINK_INTERFACE_H

#include "core/runtime/loop.h"

#define iso_the_interface ISO_REAL_NAME(iso_the_interface)

/* An input that comes in over the link: each one that is no function of time, and each one with `safe` in the scene. */
typedef struct iso_wire {
    uint16_t input; /* its place in u */
    real safe;      /* its value in a free run when no inputs have come */
    uint32_t after; /* for so many ticks; 0: it keeps the last value for ever */
} iso_wire;

/* A service works between two ticks, on a channel of its own. */
typedef struct iso_service {
    void (*start)(iso_loop *loop);  /* once, behind iso_loop_start */
    void (*before)(iso_loop *loop); /* before each tick, and repeatedly while the plant rests or waits: takes bytes that
                                       came in, and answers; may set parameters */
    void (*after)(iso_loop *loop);  /* after each tick, with its outputs published: sends */
} iso_service;

typedef struct iso_interface {
    uint64_t identity;     /* of the plant with its method, step and type of numbers: both ends must have the same */
    const iso_wire *wires; /* [wire_count], in the order of a frame */
    const iso_service *const *services; /* [service_count]: those that were asked for */
    uint16_t wire_count;
    uint16_t service_count;
    real *values;            /* [wire_count] room for the received values */
    uint8_t *received;       /* [frame_bytes] room for a frame from the controller */
    uint8_t *sent;           /* [frame_bytes] room for a frame to it */
    size_t frame_bytes;      /* ISO_LINK_BYTES (core/link/link.h) */
    unsigned char *snapshot; /* [snapshot_bytes] for a snapshot of the plant (core/runtime/snapshot.h) */
    size_t snapshot_bytes;
} iso_interface;

extern const iso_interface iso_the_interface;

#endif
