/* The machine timer as the periodic tick. */
#ifndef ISO_PORT_VIRT_TICK_H
#define ISO_PORT_VIRT_TICK_H

/* What the interrupt of the timer does. */
void tick_interrupt(void);

#endif
