/* The machine timer as the periodic tick. */
#ifndef ISO_PORT_VIRT_TICK_H
#define ISO_PORT_VIRT_TICK_H

#include <stdint.h>

/* The bit of mstatus. */
enum { INTERRUPTS_ON = 1 << 3 };

/* The timer, in its own counts. */
uint64_t tick_timer(void);

static inline void interrupts_off(void)
{
    __asm__ volatile("csrc mstatus, %0" ::"r"(INTERRUPTS_ON) : "memory");
}

static inline void interrupts_on(void)
{
    __asm__ volatile("csrs mstatus, %0" ::"r"(INTERRUPTS_ON) : "memory");
}

/* With interrupts held off: clock and ticks go on as if so many counts had not been. */
void tick_pause(uint64_t counts);

/* The handler of the interrupt of the timer. */
void tick_interrupt(void);

#endif
