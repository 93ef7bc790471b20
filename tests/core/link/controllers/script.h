/* A channel whose bytes are a script: the program that is tested calls fake_receive and fake_send in the port's place.
 */
#ifndef ISO_TESTS_LINK_SCRIPT_H
#define ISO_TESTS_LINK_SCRIPT_H

#include <string.h>

#include "port/channel.h"

static struct {
    uint8_t in[128];
    size_t count, taken, sent;
} wire;

size_t fake_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    const size_t left = wire.count - wire.taken, taken = count < left ? count : left;
    (void)channel;
    if (taken > 0) {
        memcpy(bytes, wire.in + wire.taken, taken);
        wire.taken += taken;
    }
    return taken;
}

bool fake_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    (void)channel, (void)bytes;
    wire.sent += count;
    return true;
}

#endif
