/* The board as a platform: SysTick is the tick and the clock, semihosting the console.
 *
 *     arguments: PROGRAM [NANOSECONDS]
 *
 * The clock counts instructions. QEMU with -icount shift=10 lets one instruction last 2^10 ns, in which SysTick at
 * 25 MHz counts 25.6 times. That would be a processor of one million instructions in a second, slower than any board.
 * So an instruction stands for one cycle of a core of 25 MHz, and the time of the plant is stretched by the same factor
 * of 25.6. On silicon this dilation is 1, and the clock counts cycles.
 */
#include "port/port.h"

#include <stdbool.h>

#include "port/mps2/semihosting.h"
#include "port/mps2/tick.h"

#define SYST_CSR (*(volatile uint32_t *)0xE000E010U)
#define SYST_RVR (*(volatile uint32_t *)0xE000E014U)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018U)

/* Counter on, with interrupt, on the processor's clock. */
enum { SYST_CSR_RUN = 0x7 };

enum { CYCLE_NS = 40 };

/* The dilation: SysTick counts per cycle, 25.6 = 2^7 / 5. Whole cycles in whole counts come in fives. */
enum { DILATION_SHIFT = 7, DILATION_OVER = 5 };

/* SysTick counts 24 bits. A longer period is made of several equal parts, each a multiple of 2^7 counts. */
enum { PART_COUNTS_MAX = 1 << 24 };

static uint32_t part_counts;
static uint32_t parts_per_tick;
static volatile uint64_t parts; /* since the start */
static volatile uint64_t ticks;
static uint32_t parts_of_tick;
static uint64_t reported;

void tick_interrupt(void)
{
    parts++;
    parts_of_tick++;
    if (parts_of_tick == parts_per_tick) {
        parts_of_tick = 0;
        ticks++;
    }
}

/* The period is rounded to what the timer can make: multiples of 200 ns for each of its parts. */
uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t fives = (period_ns + CYCLE_NS * DILATION_OVER / 2) / (CYCLE_NS * DILATION_OVER);
    const uint32_t fives_max = PART_COUNTS_MAX >> DILATION_SHIFT;
    parts_per_tick = (fives + fives_max - 1) / fives_max;
    const uint32_t part_fives = (fives + parts_per_tick / 2) / parts_per_tick;
    part_counts = part_fives << DILATION_SHIFT;

    SYST_RVR = part_counts - 1;
    SYST_CVR = 0;
    SYST_CSR = SYST_CSR_RUN;
    return part_fives * DILATION_OVER * parts_per_tick;
}

/* Interrupts are held off between the look and the sleep, so that a tick cannot slip in between; a pending one wakes
 * the processor all the same. */
uint64_t iso_port_wait(void)
{
    bool due = false;
    while (!due) {
        __asm__ volatile("cpsid i" ::: "memory");
        due = ticks != reported;
        reported = ticks;
        if (!due) {
            __asm__ volatile("wfi" ::: "memory");
        }
        __asm__ volatile("cpsie i\n    isb" ::: "memory");
    }
    return reported;
}

/* Reads again if a part ended between the two readings, or between the halves of one. */
uint64_t iso_port_clock(void)
{
    uint64_t before;
    uint32_t left;
    do {
        before = parts;
        left = SYST_CVR;
    } while (before != parts);
    const uint64_t counts = before * part_counts + (part_counts - 1 - left);
    return (counts * DILATION_OVER + (1 << (DILATION_SHIFT - 1))) >> DILATION_SHIFT;
}

void iso_port_read(real *const u, const size_t inputs)
{
    (void)u;
    (void)inputs;
}

void iso_port_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

void iso_port_safe(void)
{
}

void iso_port_write(const void *const bytes, const size_t count)
{
    semihosting_write(bytes, count);
}

uint64_t iso_port_duration(const int argc, char **const argv)
{
    uint64_t duration = 0;
    if (argc > 1) {
        for (const char *digit = argv[1]; *digit >= '0' && *digit <= '9'; digit++) {
            duration = duration * 10 + (uint64_t)(*digit - '0');
        }
    }
    return duration;
}

_Noreturn void iso_port_exit(const int status)
{
    semihosting_exit(status);
}
