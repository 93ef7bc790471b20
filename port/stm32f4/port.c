/* Time on the STM32F4: SysTick makes the ticks, and is the clock; it counts cycles of the core, also while that sleeps,
 * as the cycle counter of the DWT does not.
 *
 * A machine without an RCC is QEMU's netduinoplus2, with SysTick at 168 MHz: there an instruction stands for a cycle.
 * With -icount shift=10 it lasts 2^10 ns, in which SysTick counts 172.032 = 21504 / 125 times, and the time of the
 * plant is stretched by as much. On silicon both numbers are 1. */
#include "port/port.h"

#include "port/mps2/interrupts.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/time.h"
#include "port/stm32f4/timer.h"

enum { STRETCH_COUNTS = 21504, STRETCH_CYCLES = 125 };

static systick_registers *const systick = (systick_registers *)SYSTICK_AT;

static struct {
    uint64_t clock;          /* at the last look at the counter, with interrupts held off */
    uint32_t count;          /* the counter then */
    volatile uint32_t ticks; /* due: the low half */
    uint32_t part;           /* cycles that SysTick counts between interrupts: a period is made of equal parts */
    uint32_t parts;          /* of a tick */
    uint32_t left;           /* of the present tick */
    uint32_t ended;          /* the parts that have ended, in cycles */
    uint64_t reported;       /* by iso_port_wait: the latest tick */
} board;

static bool is_emulated(void)
{
    return the_clock.source == CLOCK_NONE;
}

/* Cycles modulo 2^32, with interrupts held off: from the remaining cycles of the part, or of the next one if its
 * interrupt is pending. The nearest count of the clock where time is stretched. */
static uint32_t counted(void)
{
    uint32_t left = systick->cvr, end = board.ended + board.part;
    if ((*(volatile uint32_t *)ICSR_AT & SYSTICK_PENDING) != 0) {
        left = systick->cvr;
        end += board.part;
    }
    const uint32_t counts = left + 1;
    return end - (is_emulated() ? (counts * STRETCH_CYCLES + STRETCH_COUNTS / 2 - 1) / STRETCH_COUNTS : counts);
}

static uint64_t looked(void)
{
    const uint32_t count = counted();
    board.clock += count - board.count;
    board.count = count;
    return board.clock;
}

void tick_interrupt(void)
{
    board.ended += board.part;
    (void)looked();
    if (--board.left == 0) {
        board.left = board.parts;
        board.ticks++;
    }
}

/* The period is rounded to whole cycles for each of its parts; where time is stretched, to whole groups of 125. */
__attribute__((cold)) uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t group_cycles = is_emulated() ? STRETCH_CYCLES : 1, group_counts = is_emulated() ? STRETCH_COUNTS : 1;
    const uint64_t cycles = ((uint64_t)period_ns * (the_clock.tree.hz / 1000000) + 500) / 1000;
    const uint32_t groups = (uint32_t)((cycles + group_cycles / 2) / group_cycles);
    const uint32_t most = SYSTICK_COUNTS / group_counts;
    board.parts = (groups + most - 1) / most;
    const uint32_t part_groups = (groups + board.parts / 2) / board.parts;
    board.part = part_groups * group_cycles;
    board.left = board.parts;
    systick->rvr = part_groups * group_counts - 1;
    systick->cvr = 0;
    systick->csr = SYSTICK_RUN;
    return board.part * board.parts;
}

#include "port/wait.h"

uint64_t iso_port_clock(void)
{
    interrupts_off();
    const uint64_t clock = looked();
    interrupts_on();
    return clock;
}

void time_idle(void)
{
    if (is_emulated()) {
        systick->csr = SYSTICK_STOP;
    }
    __asm__ volatile("wfi" ::: "memory");
    if (is_emulated()) {
        systick->csr = SYSTICK_RUN;
    }
}
