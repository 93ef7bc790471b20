/* The part to fill in: the few functions that a port needs of a board. The rest, port.c, is the same everywhere.
 *
 * As it stands it compiles for any processor, and does nothing. Look up each register in the manual of your chip, and
 * write down where it stands there. */
#ifndef ISO_PORT_TEMPLATE_HARDWARE_H
#define ISO_PORT_TEMPLATE_HARDWARE_H

#include <stdbool.h>
#include <stdint.h>

/* --- Time -------------------------------------------------------------------------------------------------------- */

/* The counts of the counter in a second. More is better: it is the resolution of `execution`. */
enum { HARDWARE_HZ = 1000000 };

/* Starts the counter, then an interrupt every `period` counts, which calls tick_interrupt() and nothing else of yours.
 * Returns the value of the counter before the first period began. Counter and interrupt must follow from one
 * oscillator: of two, one would drift against the other, and the ticks would come late.
 *
 * On a Cortex-M, SysTick makes the interrupt (its name in the table of port/mps2/start.c is tick_interrupt already),
 * and the cycle counter of the DWT is the counter. Where a timer is too narrow for a period of 1 s, let it interrupt
 * several times in a tick, and call tick_interrupt() in the last one: port/mps2/port.c does so. */
static inline uint32_t hardware_start(const uint32_t period)
{
    (void)period;
    return 0;
}

/* The counter: 32 bits that count up and start again at 0. It must not pass through all of them between two ticks. One
 * of 16 bits you extend here, by an interrupt of its own: port/atmega1284p/port.c does so. */
static inline uint32_t hardware_count(void)
{
    return 0;
}

/* Holds interrupts off, and lets them come again. A Cortex-M: "cpsid i" and "cpsie i"; RISC-V: bit 3 of mstatus.
 * Nothing here is held off for longer than some instructions. */
static inline void hardware_interrupts_off(void)
{
}

static inline void hardware_interrupts_on(void)
{
}

/* Sleeps until an interrupt is pending, with interrupts held off: "wfi" of both returns then as well, so that none can
 * come between the check for due ticks and the sleep. On a processor where it does not, such as an AVR, the instruction
 * that lets interrupts come again must stand directly before the one that sleeps. An empty function is correct too: the
 * processor then runs on. */
static inline void hardware_sleep(void)
{
}

/* --- Console ----------------------------------------------------------------------------------------------------- */

/* Writes a byte, and waits until there is room for it: none may be lost. A run writes one row of outputs each tick: 1
 * byte, and 4 for each output, so that eight outputs at 1 kHz need 330 kBd; a line that takes longer than the rest of a
 * tick delays ticks. */
static inline void hardware_put(const uint8_t byte)
{
    (void)byte;
}

/* How long to run, in nanoseconds. 0 is until reset; a debugger, an EEPROM or a switch can set another. */
static inline uint64_t hardware_duration(void)
{
    return 0;
}

/* The program is over: send the status, if there is a way. Then it rests. */
static inline void hardware_end(const int status)
{
    (void)status;
}

#endif
