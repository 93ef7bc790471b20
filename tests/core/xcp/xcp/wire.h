/* A channel of a test: bytes of `in` come in, bytes that are sent stand in `out`, as long as it has room. */
#ifndef TESTS_UNIT_XCP_WIRE_H
#define TESTS_UNIT_XCP_WIRE_H

#include "tests/core/xcp/xcp/ask.h"

static struct {
    uint8_t in[1200], out[4096];
    size_t in_count, taken, out_count;
    unsigned room; /* messages that can still be sent */
    uint32_t opened;
} wire;

size_t fake_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    const size_t left = wire.in_count - wire.taken, taken = count < left ? count : left;
    (void)channel;
    memcpy(bytes, wire.in + wire.taken, taken);
    wire.taken += taken;
    return taken;
}

bool fake_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    (void)channel;
    if (wire.room == 0 || count > sizeof wire.out - wire.out_count) {
        return false;
    }
    wire.room--;
    memcpy(wire.out + wire.out_count, bytes, count);
    wire.out_count += count;
    return true;
}

uint32_t fake_opened(const iso_channel channel)
{
    (void)channel;
    return wire.opened;
}

#endif
