/* SysTick as the periodic tick and the clock. */
#ifndef ISO_PORT_MPS2_TICK_H
#define ISO_PORT_MPS2_TICK_H

#include <stdint.h>

#define SYST_CSR (*(volatile uint32_t *)0xE000E010U)

/* Counter on, with interrupt, on the processor's clock; and the counter stopped, which keeps its value. */
enum { SYST_CSR_RUN = 0x7, SYST_CSR_STOP = 0x6 };

/* The handler of the SysTick exception. */
void tick_interrupt(void);

#endif
