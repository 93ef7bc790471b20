/* Time of the board, as its serial lines see it. */
#ifndef ISO_PORT_STM32F4_TIME_H
#define ISO_PORT_STM32F4_TIME_H

#include <stdbool.h>

/* The handler of the SysTick exception. */
void tick_interrupt(void);

/* With interrupts held off: sleeps until an interrupt is pending. On silicon time goes on, in QEMU it stands still. */
void time_idle(void);

#endif
