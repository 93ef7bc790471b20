/* What port/template asks of a board, for the board AN386 in QEMU: one that somebody has filled in. SysTick makes the
 * ticks, the cycle up counter of the board counts (Arm (2016), Application Note AN386: 3.5 FPGA system control), and
 * semihosting is the rest. */
#ifndef ISO_TESTS_PORT_HARDWARE_H
#define ISO_TESTS_PORT_HARDWARE_H

#include <stdint.h>

#include "port/mps2/semihosting.h"
#include "port/mps2/tick.h"

enum { HARDWARE_HZ = 25000000 };

#define COUNTER (*(volatile uint32_t *)0x40028018U)
#define PRESCALE (*(volatile uint32_t *)0x4002801CU)

static inline uint32_t hardware_count(void)
{
    return COUNTER;
}

static inline uint32_t hardware_start(const uint32_t period)
{
    PRESCALE = 0;
    *(volatile uint32_t *)0xE000E014U = period - 1;
    const uint32_t count = hardware_count();
    *(volatile uint32_t *)0xE000E018U = 0;
    SYST_CSR = SYST_CSR_RUN;
    return count;
}

static inline void hardware_interrupts_off(void)
{
    __asm__ volatile("cpsid i" ::: "memory");
}

static inline void hardware_interrupts_on(void)
{
    __asm__ volatile("cpsie i" ::: "memory");
}

/* The time of QEMU with sleep=off goes on by two periods where a processor sleeps through one, which this counter
 * shows: so it runs on. */
static inline void hardware_sleep(void)
{
}

static inline void hardware_put(const uint8_t byte)
{
    semihosting_write(&byte, 1);
}

static inline uint64_t hardware_duration(void)
{
    char *words[3];
    uint64_t duration = 0;
    if (semihosting_arguments(words, 3) > 1) {
        for (const char *digit = words[1]; *digit >= '0' && *digit <= '9'; digit++) {
            duration = duration * 10 + (uint64_t)(*digit - '0');
        }
    }
    return duration;
}

static inline void hardware_end(const int status)
{
    semihosting_exit(status);
}

#endif
