/* The machine timer as the periodic tick. */
#ifndef ISO_PORT_VIRT_TICK_H
#define ISO_PORT_VIRT_TICK_H

/* The handler of the interrupt of the timer. */
void tick_interrupt(void);

#endif
