/* Timer 1 of an ATmega1284P, which counts every cycle. */
#include "tests/port/soft/timer.h"

#define TCCR1B (*(volatile uint8_t *)(uintptr_t)0x81)
#define TCNT1 (*(volatile uint16_t *)(uintptr_t)0x84)

void timer_start(void)
{
    TCCR1B = 1;
}

uint16_t timer_now(void)
{
    return TCNT1;
}
