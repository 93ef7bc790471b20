/* SysTick, and the timer of the pulse widths. Armv7-M Architecture Reference Manual, DDI 0403E.e: B3.3 SysTick, B3.2.4
 * ICSR. RM0090 18.4, RM0390 17.4: TIM3. */
#ifndef ISO_PORT_STM32F4_TIMER_H
#define ISO_PORT_STM32F4_TIMER_H

#include <stdint.h>

typedef struct systick_registers {
    volatile uint32_t csr, rvr, cvr;
} systick_registers;

#define SYSTICK_AT UINT32_C(0xE000E010)
#define ICSR_AT UINT32_C(0xE000ED04)
enum { SYSTICK_RUN = 7, SYSTICK_STOP = 6, SYSTICK_COUNTS = 1 << 24, SYSTICK_PENDING = 1 << 26 };

typedef struct timer_registers {
    volatile uint32_t cr1, cr2, smcr, dier, sr, egr, ccmr[2], ccer, cnt, psc, arr, reserved, ccr[4];
} timer_registers;

#define TIM3_AT UINT32_C(0x40000400)
/* A channel in mode 1 is high while the counter is below its register, which is taken over at the end of a period; egr
 * takes it over at once. */
enum {
    TIMER_ON = 1 << 0,
    TIMER_RELOAD = 1 << 7,
    TIMER_TAKE_OVER = 1 << 0,
    CHANNEL_MODE_1 = 6 << 4,
    CHANNEL_PRELOAD = 1 << 3
};
enum { PWM_HZ = 20000 };

#endif
