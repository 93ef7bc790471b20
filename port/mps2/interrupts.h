/* Interrupts of a Cortex-M: held off and let, and a table of exceptions with more of them than the start has. */
#ifndef ISO_PORT_MPS2_INTERRUPTS_H
#define ISO_PORT_MPS2_INTERRUPTS_H

#include <stdint.h>
#include <string.h>

typedef void interrupt_handler(void);

/* The exceptions, whose entries stand before those of the interrupts. */
enum { EXCEPTIONS = 16 };

static inline void interrupts_off(void)
{
    __asm__ volatile("cpsid i" ::: "memory");
}

static inline void interrupts_on(void)
{
    __asm__ volatile("cpsie i" ::: "memory");
}

/* From now on this table holds: it gets the exceptions of the present one. It stands at a multiple of its size, rounded
 * up to a power of two. Arm (2021), Armv7-M Architecture Reference Manual, DDI 0403E.e: B3.2.5. */
static inline void interrupts_table(interrupt_handler **const table)
{
    const uint32_t *volatile *const vtor = (const uint32_t *volatile *)0xE000ED08U;
    memcpy(table, *vtor, EXCEPTIONS * sizeof table[0]);
    *vtor = (const uint32_t *)(uintptr_t)table;
    __asm__ volatile("dsb\n    isb" ::: "memory");
}

/* Lets an interrupt come, by its number. */
static inline void interrupts_let(const unsigned interrupt)
{
    ((volatile uint32_t *)0xE000E100U)[interrupt / 32] = UINT32_C(1) << interrupt % 32;
}

#endif
