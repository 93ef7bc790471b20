/* Bytes as what comes in at a slave: as packets, a length before each, and as a stream of frames. Addresses are those
 * of its memory, from 0 on. */
#include <stdlib.h>

#include "tests/core/xcp/masters/world.h"

enum { STATES = 6, TUNABLES = 40, OUTPUTS = 6 };

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

static struct {
    real x[STATES];
    real p[TUNABLES];
    real y[OUTPUTS];
} memory;

static iso_limits limits[TUNABLES];

static void must(const bool good)
{
    if (!good) {
        abort();
    }
}

static void start(world *const w, const bool is_locked)
{
    static const iso_xcp_description descriptions[] = {
        {"fuzz", "0", limits, NULL, {2, 10000}, {6, 1}},
        {"fuzz", "0", limits, &iso_xcp_example_lock, {2, 10000}, {6, 1}},
    };
    static const uint8_t connect[] = {ISO_XCP_CONNECT, 0};
    for (size_t i = 0; i < TUNABLES; i++) {
        limits[i] = (iso_limits){-(real)i, (real)i};
        memory.p[i] = R(0.0);
    }
    world_start(w, &descriptions[is_locked], &memory, sizeof memory, (world_part){memory.p, TUNABLES},
                (world_part){memory.x, STATES});
    must(world_take(w, connect, sizeof connect));
}

/* Puts the plant's addresses into a packet that has one. */
static void place(uint8_t *const packet, const uint16_t length)
{
    switch (length < 8 ? 0 : packet[0]) {
    case ISO_XCP_SET_MTA:
    case ISO_XCP_SHORT_UPLOAD:
    case ISO_XCP_SHORT_DOWNLOAD:
    case ISO_XCP_WRITE_DAQ:
        iso_xcp_put_long(packet + 4, iso_xcp_long(packet + 4) + iso_xcp_address(&memory));
        break;
    default:
        break;
    }
}

static void take_packets(world *const w, const uint8_t *const bytes, const size_t count)
{
    for (size_t at = 0; at < count;) {
        const size_t left = count - at - 1;
        const uint16_t length = bytes[at] < left ? bytes[at] : (uint16_t)left;
        uint8_t *const packet = malloc(length); /* as long as it is, so that a look behind it is found */
        memcpy(packet, bytes + at + 1, length);
        place(packet, length);
        must(world_take(w, packet, length) && world_sample(w) && world_stimulate(w));
        free(packet);
        w->slave.tick++;
        at += 1U + length;
    }
}

static void take_stream(world *const w, const uint8_t *const bytes, const size_t count, const bool is_serial)
{
    iso_xcp_reader reader = {.is_serial = is_serial};
    for (size_t i = 0; i < count; i++) {
        reader.bytes[reader.used++] = bytes[i];
        for (uint16_t n = iso_xcp_read(&reader); n > 0; n = iso_xcp_read(&reader)) {
            must(world_take(w, reader.bytes + ISO_XCP_HEADER_BYTES, n));
        }
        must(reader.used < sizeof reader.bytes && iso_xcp_missing(&reader) <= sizeof reader.bytes - reader.used);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *const bytes, const size_t count)
{
    static world w;
    for (unsigned kind = 0; kind < 2; kind++) {
        start(&w, kind == 1);
        take_packets(&w, bytes, count);
        start(&w, false);
        take_stream(&w, bytes, count, kind == 1);
    }
    return 0;
}
