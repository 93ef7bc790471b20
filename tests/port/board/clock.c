/* port/mps2 on the board: the clock where its low word wraps, and that what interrupts share is volatile. */
#include CLOCK_OF /* port/mps2/port.c, so that its time can be set */

#include "tests/tap.h"

#define IS_VOLATILE(object, type) _Generic(&(object), volatile type * : true, default : false)

/* Ticks of 1 ms from 2000 counts before the low word ends: the clock goes on through it, and by a period from tick to
 * tick. */
static void test_wrap(void)
{
    enum { TICKS = 4 };
    const uint32_t period = iso_port_start(1000000);
    (void)iso_port_wait();
    board.end += UINT32_MAX - board.end - 2000;
    const uint64_t begin = iso_port_clock();
    uint64_t last = begin, falls = 0;
    const uint64_t first = iso_port_wait();
    for (uint64_t now = first; now < first + TICKS; now = iso_port_wait()) {
        const uint64_t clock = iso_port_clock();
        falls += clock <= last || clock - last > 2 * (uint64_t)period;
        last = clock;
    }
    tap_ok(begin <= UINT32_MAX && last > UINT32_MAX, "the high word of the clock counts");
    tap_ok(falls == 0, "and the clock goes on through it");
}

static void test_shared(void)
{
    tap_ok(IS_VOLATILE(board.end, uint32_t) && IS_VOLATILE(board.end_high, uint32_t) &&
               IS_VOLATILE(board.ticks, uint32_t),
           "what the interrupt of the tick changes is volatile");
}

int main(void)
{
    test_wrap();
    test_shared();
    tap_done();
}
