/* Time on the RP2040: SysTick makes the ticks, and is the clock; it counts cycles of the core, also while that sleeps.
 */
#include "port/port.h"

#include "port/mps2/interrupts.h"
#include "port/rp2040/pins.h"
#include "port/rp2040/registers.h"
#include "port/rp2040/start.h"

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

/* Cycles modulo 2^32, with interrupts held off: from the remaining cycles of the part, or of the next one if its
 * interrupt is pending. */
static uint32_t counted(void)
{
    uint32_t left = SYSTICK[SYSTICK_CVR], end = board.ended + board.part;
    if ((ICSR & SYSTICK_PENDING) != 0) {
        left = SYSTICK[SYSTICK_CVR];
        end += board.part;
    }
    return end - (left + 1);
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
    if (--board.left == 0) {
        pins_latch(board.ended);
        board.left = board.parts;
        board.ticks++;
    }
    (void)looked();
}

/* The period is rounded to whole cycles for each of its parts. */
__attribute__((cold)) uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t cycles = (uint32_t)(((uint64_t)period_ns * SYSTEM_MHZ + 500) / 1000);
    board.parts = (cycles + SYSTICK_COUNTS - 1) / SYSTICK_COUNTS;
    board.part = (cycles + board.parts / 2) / board.parts;
    board.left = board.parts;
    start_tell(pins_begin(board.part * board.parts));
    SYSTICK[SYSTICK_RVR] = board.part - 1;
    SYSTICK[SYSTICK_CVR] = 0;
    SYSTICK[SYSTICK_CSR] = SYSTICK_RUN;
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

void iso_port_read(real *const u, const size_t inputs)
{
    pins_read(u, inputs);
}

void iso_port_publish(const real *const y, const size_t outputs)
{
    pins_publish(y, outputs);
}

void iso_port_safe(void)
{
    pins_safe();
}
