/* A slave with the memory that it shows, and what must hold after every packet, whatever it is: a response has its
 * size; memory but for the tunables stays as it was; these stay, if the packet is refused, and are finite and within
 * their limits, if it is not; samples have their sizes. */
#ifndef TESTS_XCP_WORLD_H
#define TESTS_XCP_WORLD_H

#include "core/xcp/service.h"

enum { WORLD_BYTES = 4096 };

typedef struct world {
    iso_xcp_slave slave;
    uint8_t *memory; /* [bytes], the tunables among them */
    size_t bytes;
    uint8_t before[WORLD_BYTES];
    uint8_t response[ISO_XCP_MAX_CTO];
    uint16_t length;     /* of the first packet of the last response */
    unsigned long whole; /* samples of stimulation */
} world;

/* Numbers of the memory that a master may write. */
typedef struct world_part {
    real *at;
    uint16_t count;
} world_part;

static inline void world_start(world *const w, const iso_xcp_description *const of, void *const memory,
                               const size_t bytes, const world_part tunables, const world_part inputs)
{
    const iso_xcp_access access = {.readable = {{memory, (uint32_t)bytes}},
                                   .tunables = tunables.at,
                                   .limits = of->limits,
                                   .tunable_count = tunables.count,
                                   .inputs = inputs.at,
                                   .input_count = inputs.count};
    w->memory = memory;
    w->bytes = bytes;
    iso_xcp_start(&w->slave, of, &access);
}

static inline bool world_is_within(const world *const w)
{
    const iso_xcp_access *const a = &w->slave.access;
    bool good = true;
    for (uint16_t i = 0; i < a->tunable_count; i++) {
        const real x = a->tunables[i];
        good = good && !iso_not_finite(x) && x >= a->limits[i].least && x <= a->limits[i].most;
    }
    return good;
}

/* What was changed is tunables alone, and only where the packet was not refused. */
static inline bool world_is_whole(const world *const w)
{
    const iso_xcp_access *const a = &w->slave.access;
    const size_t from = (size_t)((uint8_t *)a->tunables - w->memory), to = from + a->tunable_count * sizeof(real);
    const bool may_write = w->length > 0 && w->response[0] == ISO_XCP_RES;
    return memcmp(w->memory, w->before, from) == 0 && memcmp(w->memory + to, w->before + to, w->bytes - to) == 0 &&
           (may_write || memcmp(w->memory + from, w->before + from, to - from) == 0);
}

/* The event of a tick. */
static inline bool world_sample(world *const w)
{
    static uint8_t packet[ISO_XCP_MAX_DTO];
    bool good = true;
    for (uint8_t list = 0; list < w->slave.daq.list_count; list++) {
        unsigned bytes = 0;
        if (!iso_xcp_daq_due(&w->slave.daq, list)) {
            continue;
        }
        for (uint8_t table = 0; table < w->slave.daq.lists[list].tables.count; table++) {
            const uint16_t length = iso_xcp_daq_packet(&w->slave.daq, list, table, (uint32_t)w->slave.tick, packet);
            good = good && length > 0 && length <= sizeof packet;
            bytes += (unsigned)(ISO_XCP_HEADER_BYTES + length + ISO_XCP_TAIL_BYTES);
        }
        good = good && bytes <= ISO_XCP_SAMPLE_BYTES;
    }
    return good;
}

/* A step with what is stimulated: nothing but inputs changes. */
static inline bool world_stimulate(world *const w)
{
    const iso_xcp_access *const a = &w->slave.access;
    const size_t from = (size_t)((uint8_t *)a->inputs - w->memory), to = from + a->input_count * sizeof(real);
    memcpy(w->before, w->memory, w->bytes);
    if (iso_xcp_stimulates(&w->slave.stimulation, &w->slave.daq)) {
        iso_xcp_stimulation_set(&w->slave.stimulation, &w->slave.access);
        (void)iso_xcp_stimulation_pass(&w->slave.stimulation);
    }
    return memcmp(w->memory, w->before, from) == 0 && memcmp(w->memory + to, w->before + to, w->bytes - to) == 0;
}

/* A packet comes in. Returns whether all holds. */
static inline bool world_take(world *const w, const uint8_t *const packet, const uint16_t length)
{
    uint8_t more[ISO_XCP_MAX_CTO];
    unsigned packets = 0;
    memcpy(w->before, w->memory, w->bytes);
    w->whole += length > 0 && packet[0] <= ISO_XCP_LAST_STIMULUS &&
                iso_xcp_stimulates(&w->slave.stimulation, &w->slave.daq) &&
                iso_xcp_stimulation_take(&w->slave.stimulation, &w->slave.daq, packet, length);
    w->length = iso_xcp_answer(&w->slave, packet, length, w->response);
    bool good = w->length <= ISO_XCP_MAX_CTO && world_is_whole(w) && world_is_within(w);
    for (uint16_t n = 1; n > 0 && good; packets++) {
        n = iso_xcp_continue(&w->slave, more);
        good = n <= ISO_XCP_MAX_CTO && packets <= ISO_XCP_BLOCK_BYTES / (ISO_XCP_MAX_CTO - 1) + 1;
    }
    return good;
}

#endif
