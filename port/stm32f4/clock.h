/* The clock tree: which oscillator, which factors of the PLL, which wait states of the flash. Facts:
 *
 *     RM0090 (STM32F405/407): 3.5.1 wait states, 5.4 PWR, 7.3 RCC
 *     RM0390 (STM32F446): 3.4.1 wait states, 5.4 PWR, 5.1.4 over-drive, 6.3 RCC
 *     data sheets DS8626 (F405/407), DS10693 (F446): limits of the PLL and of the buses
 */
#ifndef ISO_PORT_STM32F4_CLOCK_H
#define ISO_PORT_STM32F4_CLOCK_H

#include <stdbool.h>
#include <stdint.h>

typedef struct rcc_registers {
    volatile uint32_t cr, pllcfgr, cfgr, cir, ahb1rstr, ahb2rstr, ahb3rstr, reserved0, apb1rstr, apb2rstr;
    uint32_t reserved1[2];
    volatile uint32_t ahb1enr, ahb2enr, ahb3enr, reserved2, apb1enr, apb2enr;
} rcc_registers;

typedef struct pwr_registers {
    volatile uint32_t cr, csr;
} pwr_registers;

#define RCC_AT UINT32_C(0x40023800)
#define PWR_AT UINT32_C(0x40007000)
#define FLASH_ACR_AT UINT32_C(0x40023C00)

/* RCC_CR. The internal oscillator is ready whenever a program runs from reset on; where it is not, there is no RCC. */
enum {
    HSI_READY = 1 << 1,
    HSE_ON = 1 << 16,
    HSE_READY = 1 << 17,
    HSE_BYPASS = 1 << 18,
    PLL_ON = 1 << 24,
    PLL_READY = 1 << 25
};
/* RCC_PLLCFGR: places of the factors. The field of P is P / 2 - 1. R is of the F446 alone, and must be 2 at least. */
enum { PLL_M_AT = 0, PLL_N_AT = 6, PLL_P_AT = 16, PLL_FROM_HSE = 1 << 22, PLL_Q_AT = 24, PLL_R_AT = 28 };
/* RCC_CFGR: the switch and its state, and dividers of the buses. */
enum { SWITCH = 3, TO_PLL = 2, STATE_AT = 2, APB1_BY_4 = 5 << 10, APB2_BY_2 = 4 << 13 };
/* Clocks of the peripherals. */
enum { TIM3_CLOCK = 1 << 1, USART2_CLOCK = 1 << 17, UART4_CLOCK = 1 << 19, PWR_CLOCK = 1 << 28, DAC_CLOCK = 1 << 29 };
enum { USART6_CLOCK = 1 << 5, ADC1_CLOCK = 1 << 8 };
/* PWR_CR and PWR_CSR: over-drive, of the F446. */
enum { OVERDRIVE_ON = 1 << 16, OVERDRIVE_SWITCH = 1 << 17, OVERDRIVE_READY = 1 << 16, OVERDRIVE_SWITCHED = 1 << 17 };
/* FLASH_ACR. */
enum { PREFETCH = 1 << 8, INSTRUCTION_CACHE = 1 << 9, DATA_CACHE = 1 << 10 };

/* A tree: the clock of the core, its factors, and the settings that follow. */
typedef struct clock_tree {
    uint32_t hz, apb1_hz, apb2_hz; /* of the core, and of the two buses; a timer of APB1 counts at twice its clock */
    uint32_t m, n, p, q;
    uint32_t wait_states;
} clock_tree;

/* At 2.7 V to 3.6 V one wait state more for each 30 MHz. */
static inline uint32_t clock_wait_states(const uint32_t hz)
{
    return (hz - 1) / 30000000;
}

/* The tree that makes hz, a multiple of 1 MHz, of an oscillator of source_hz, a multiple of 2 MHz: the PLL compares at
 * 2 MHz, which has the least jitter, and doubles. Buses at a quarter and a half. */
static inline clock_tree clock_tree_of(const uint32_t source_hz, const uint32_t hz)
{
    const uint32_t compared = 2000000, vco = 2 * hz;
    return (clock_tree){.hz = hz,
                        .apb1_hz = hz / 4,
                        .apb2_hz = hz / 2,
                        .m = source_hz / compared,
                        .n = vco / compared,
                        .p = 2,
                        .q = (vco + 47999999) / 48000000,
                        .wait_states = clock_wait_states(hz)};
}

static inline uint32_t clock_pllcfgr(const clock_tree *const t, const bool from_hse)
{
    return t->m << PLL_M_AT | t->n << PLL_N_AT | (t->p / 2 - 1) << PLL_P_AT | (from_hse ? (uint32_t)PLL_FROM_HSE : 0) |
           t->q << PLL_Q_AT | UINT32_C(2) << PLL_R_AT;
}

/* Where the clock came from in the end. */
typedef enum clock_source {
    CLOCK_NONE, /* no RCC answers: a machine that has none, and runs at its own rate */
    CLOCK_HSI,  /* the PLL did not lock: the internal oscillator, 16 MHz */
    CLOCK_PLL_HSI,
    CLOCK_PLL_HSE
} clock_source;

typedef struct clock_state {
    clock_tree tree;
    clock_source source;
} clock_state;

extern clock_state the_clock;

/* Turns it all on, in a bounded time: a unit that does not answer is not used. */
void clock_start(void);

#endif
