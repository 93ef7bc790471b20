/* The board as a platform: SysTick is the tick and the clock, semihosting the console.
 *
 * The clock counts instructions. QEMU with -icount shift=10 lets one instruction last 2^10 ns, in which SysTick at
 * 25 MHz counts 25.6 times. That would be a processor of one million instructions in a second, slower than any board.
 * So an instruction stands for one cycle of a core of 25 MHz, or of BOARD_CYCLE_NS, and the time of the plant is
 * stretched by the same factor of 25.6, or more; 20.48 at the 20 MHz of the AN505, 32.768 on the AN547. On silicon
 * this dilation is 1, and the clock counts cycles.
 */
#include "port/port.h"

#include "port/mps2/board.h"
#include "port/mps2/interrupts.h"
#include "port/mps2/tick.h"
#include "port/none/inputs.h"
#include "port/none/outputs.h"

#define SYST_RVR (*(volatile uint32_t *)0xE000E014U)
#define SYST_CVR (*(volatile uint32_t *)0xE000E018U)

#ifdef BOARD_CYCLE_NS
enum { CYCLE_NS = BOARD_CYCLE_NS };
#else
enum { CYCLE_NS = 1000 / BOARD_MHZ };
#endif

/* The dilation: SysTick counts per cycle, 2^SHIFT / OVER: 25.6 = 2^7 / 5. Whole cycles in whole counts come in groups
 * of OVER. */
enum { DILATION_SHIFT = BOARD_DILATION_SHIFT, DILATION_OVER = BOARD_DILATION_OVER };

/* SysTick counts 24 bits. A longer period is made of several equal parts, each a multiple of 2^SHIFT counts. */
enum { PART_COUNTS_MAX = 1 << 24 };

/* The time of the board as the interrupt leaves it: all in one place, since a function takes an address for each
 * object. Members that the program reads while the interrupt may come have 32 bits, so that one load takes each. */
static struct {
    volatile uint32_t end, end_high; /* of the present part, in counts of the clock */
    volatile uint32_t ticks;         /* due: the low half */
    uint32_t part;                   /* the length of a part in counts of the clock */
    uint32_t parts;                  /* of a tick */
    uint32_t left;                   /* of the present tick */
    uint64_t reported;               /* by iso_port_wait: the latest tick */
} board;

void tick_interrupt(void)
{
    const uint32_t end = board.end + board.part;
    board.end = end;
    board.end_high += end < board.part;
    if (--board.left == 0) {
        board.left = board.parts;
        board.ticks++;
    }
}

/* The period is rounded to one that the timer can make: multiples of five cycles for each of its parts, or of 25. */
__attribute__((cold)) uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t fives = (period_ns + CYCLE_NS * DILATION_OVER / 2) / (CYCLE_NS * DILATION_OVER);
    const uint32_t fives_max = PART_COUNTS_MAX >> DILATION_SHIFT;
    board.parts = (fives + fives_max - 1) / fives_max;
    const uint32_t part_fives = (fives + board.parts / 2) / board.parts;
    board.part = part_fives * DILATION_OVER;
    board.end = board.part;
    board.left = board.parts;

    SYST_RVR = (part_fives << DILATION_SHIFT) - 1;
    SYST_CVR = 0;
    SYST_CSR = SYST_CSR_RUN;
    return board.part * board.parts;
}

#include "port/wait.h"

/* Reads again if a part ended between the readings. SysTick counts down to the end of the part; the nearest count of
 * the clock is taken. */
uint64_t iso_port_clock(void)
{
    uint32_t low, left, high;
    do {
        low = board.end;
        left = SYST_CVR;
        high = board.end_high;
    } while (low != board.end);
    const uint32_t half = 1 << (DILATION_SHIFT - 1), whole = (1 << DILATION_SHIFT) - 1;
    return ((uint64_t)high << 32 | low) - (((left + 1) * DILATION_OVER + whole - half) >> DILATION_SHIFT);
}
