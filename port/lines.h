/* Serial lines as channels: bytes wait in rings between the lines and the program. A port's C file defines the
 * following, then includes this file, and so has iso_port_receive, iso_port_opened, iso_port_send and iso_port_idle:
 *
 *   LINES_INTERRUPT              whether interrupts move bytes; else they move when the program asks
 *   move(channel)                from the line to its ring and from the ring to the line, with interrupts held off
 *   start_lines()                opens all lines, when the first is used
 *   sleep()                      until an interrupt is pending, with interrupts held off
 *   interrupts_off(), interrupts_on()
 */
#ifndef ISO_PORT_LINES_H
#define ISO_PORT_LINES_H

#include "port/ring.h"

static void open_lines(void)
{
    static bool is_open;
    if (!is_open) {
        is_open = true;
        start_lines();
    }
}

static void move_now(const iso_channel channel)
{
    interrupts_off();
    move(channel);
    interrupts_on();
}

size_t iso_port_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    open_lines();
    if (!LINES_INTERRUPT) {
        move_now(channel);
    }
    const size_t taken = ring_take_all(&lines[channel].in, bytes, count);
    if (LINES_INTERRUPT && taken > 0) { /* a byte that found the ring full gives no other interrupt */
        move_now(channel);
    }
    return taken;
}

/* A serial line does not show whether its other end is open. */
uint32_t iso_port_opened(const iso_channel channel)
{
    (void)channel;
    return 0;
}

bool iso_port_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    open_lines();
    if (!ring_put_all(&lines[channel].out, bytes, count)) {
        return false;
    }
    move_now(channel);
    return true;
}

/* Interrupts are held off between the look and the sleep; a pending one wakes the processor all the same. */
void iso_port_idle(void)
{
    open_lines();
    interrupts_off();
    bool came = false;
    for (unsigned channel = 0; channel < ISO_CHANNELS; channel++) {
        if (!LINES_INTERRUPT) {
            move((iso_channel)channel);
        }
        came = came || !ring_is_empty(&lines[channel].in);
    }
    if (!came) {
        sleep();
    }
    interrupts_on();
}

#endif
