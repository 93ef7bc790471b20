/* SysTick as the periodic tick and the clock. */
#ifndef ISO_PORT_MPS2_TICK_H
#define ISO_PORT_MPS2_TICK_H

/* The handler of the SysTick exception. */
void tick_interrupt(void);

#endif
