/* The machine timer as the periodic tick. */
#ifndef ISO_PORT_VIRT_TICK_H
#define ISO_PORT_VIRT_TICK_H

#include <stdint.h>

/* The timer, in its own counts. */
uint64_t tick_timer(void);

/* With interrupts held off: clock and ticks go on as if so many counts had not been. */
void tick_pause(uint64_t counts);

/* The handler of the interrupt of the timer. */
void tick_interrupt(void);

#endif
