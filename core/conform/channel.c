/* The channel for a controller: a byte out says that it is open; then it sends each received byte back, until all have
 * come. The reader sends and compares. */
#include "port/channel.h"
#include "core/conform/pattern.h"
#include "core/conform/report.h"

bool conform_channel(void)
{
    static uint8_t bytes[ISO_CHANNEL_BYTES];
    uint32_t done = 0;
    const uint8_t open = CONFORM_OPEN;
    while (!iso_port_send(ISO_CHANNEL_CONTROLLER, &open, sizeof open)) {
    }
    while (done < CONFORM_CHANNEL_BYTES) {
        const size_t count = iso_port_receive(ISO_CHANNEL_CONTROLLER, bytes, sizeof bytes);
        if (count == 0) {
            iso_port_idle();
            continue;
        }
        while (!iso_port_send(ISO_CHANNEL_CONTROLLER, bytes, count)) {
        }
        done += (uint32_t)count;
    }
    iso_port_drain();
    return true;
}
