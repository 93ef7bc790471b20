/* QEMU's RISC-V board `virt` as a platform: the machine timer is the tick and the clock, semihosting the console.
 *
 * The clock counts instructions. QEMU with -icount shift=10 lets one instruction last 2^10 ns, in which the timer at 10
 * MHz counts 10.24 times. An instruction stands for one cycle of a core of 100 MHz, and the time of the plant is
 * stretched by 102.4. On silicon a timer counts at a rate of its own. RISC-V (2021), The RISC-V Instruction Set Manual,
 * Volume II: Privileged Architecture, version 20211203: 3.2.1. */
#include "port/port.h"

#include "port/none/inputs.h"
#include "port/none/outputs.h"
#include "port/virt/tick.h"

#define MTIME ((volatile uint32_t *)0x0200BFF8U)
#define MTIMECMP ((volatile uint32_t *)0x02004000U)

#ifdef BOARD_CYCLE_NS
enum { CYCLE_NS = BOARD_CYCLE_NS };
#else
enum { CYCLE_NS = 10 };
#endif

/* The timer counts 10.24 = 2^8 / 25 times in a cycle: whole cycles in whole counts come in 25. */
enum { DILATION_SHIFT = 8, DILATION_OVER = 25 };

/* The bit of mie. */
enum { TIMER_ON = 1 << 7 };

static struct {
    uint64_t start;          /* of the clock, in counts of the timer */
    uint64_t next;           /* when the next tick is due, likewise */
    uint32_t period;         /* likewise */
    volatile uint32_t ticks; /* due: the low half */
    uint64_t reported;       /* by iso_port_wait: the latest tick */
} board;

uint64_t tick_timer(void)
{
    uint32_t high, low;
    do {
        high = MTIME[1];
        low = MTIME[0];
    } while (high != MTIME[1]);
    return (uint64_t)high << 32 | low;
}

/* The high half stands at its most meanwhile, so that no time between is due. */
static void set_alarm(const uint64_t time)
{
    MTIMECMP[1] = UINT32_MAX;
    MTIMECMP[0] = (uint32_t)time;
    MTIMECMP[1] = (uint32_t)(time >> 32);
}

void tick_pause(const uint64_t counts)
{
    board.start += counts;
    board.next += counts;
    set_alarm(board.next);
}

void tick_interrupt(void)
{
    board.next += board.period;
    set_alarm(board.next);
    board.ticks++;
}

/* The period is rounded to one that the timer can make: multiples of 250 ns. */
__attribute__((cold)) uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t parts = (period_ns + CYCLE_NS * DILATION_OVER / 2) / (CYCLE_NS * DILATION_OVER);
    board.period = parts << DILATION_SHIFT;
    board.start = tick_timer();
    board.next = board.start + board.period;
    set_alarm(board.next);
    __asm__ volatile("csrs mie, %0" ::"r"(TIMER_ON) : "memory");
    interrupts_on();
    return parts * DILATION_OVER;
}

#include "port/wait.h"

/* The nearest count of the clock. */
uint64_t iso_port_clock(void)
{
    const uint32_t half = 1 << (DILATION_SHIFT - 1);
    return ((tick_timer() - board.start) * DILATION_OVER + half) >> DILATION_SHIFT;
}
