/* Waiting for a tick that an interrupt counts. A port's C file includes this behind its `board`, with the members
 *
 *   volatile uint32_t ticks      that are due: the low half of their number
 *   uint64_t reported            by iso_port_wait: the latest tick
 *
 * and behind interrupts_off() and interrupts_on(), and has iso_port_wait. */
#ifndef ISO_PORT_WAIT_H
#define ISO_PORT_WAIT_H

/* Ticks that are due and that the last call of iso_port_wait did not report; less than 2^32. */
static uint32_t due(void)
{
    return board.ticks - (uint32_t)board.reported;
}

/* Interrupts are held off between the look and the sleep, so that a tick cannot slip in between; a pending one wakes
 * the processor all the same. */
uint64_t iso_port_wait(void)
{
    uint32_t ticks = due();
    while (ticks == 0) {
        interrupts_off();
        if (due() == 0) {
            __asm__ volatile("wfi" ::: "memory");
        }
        interrupts_on();
        ticks = due();
    }
    board.reported += ticks;
    return board.reported;
}

#endif
