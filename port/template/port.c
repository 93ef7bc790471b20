/* A port, to be copied: its nine functions (port/port.h), with the duty of each and its reason. The functions of your
 * board stand in hardware.h. `tools/isochron conform --target NAME` checks the result, duty by duty. */
#include "port/port.h"

#include "port/template/hardware.h"

/* Members that the interrupt of the tick shares with the program are volatile, and of 32 bits, so that one load takes
 * each: the program never sees half of a change. On a processor with narrower loads, hold interrupts off around each of
 * them, as port/atmega1284p does. */
static struct {
    uint64_t clock;          /* at the last look at the counter; touched with interrupts held off */
    uint32_t count;          /* the counter then */
    volatile uint32_t ticks; /* due: the low half */
    uint64_t reported;       /* by iso_port_wait: the latest tick */
} board;

/* The counter has 32 bits, the clock 64: less than 2^32 counts pass between two calls, since the interrupt of the tick
 * calls it as well. With interrupts held off. */
static uint64_t looked(void)
{
    const uint32_t count = hardware_count();
    board.clock += count - board.count;
    board.count = count;
    return board.clock;
}

/* The interrupt of the tick. Its name is that in the table of exceptions; it runs at every period, and is short: its
 * time is taken from the step that it interrupts. It may use no floating-point register that is not saved for it. */
void tick_interrupt(void);
void tick_interrupt(void)
{
    (void)looked();
    board.ticks++;
}

/* DUTY start: a tick every period_ns from now on, the clock at 0. Returns the period in counts, which must be a whole
 * number: the nearest is taken, and the plant's time stays a multiple of its step whatever was taken. */
uint32_t iso_port_start(const uint32_t period_ns)
{
    const uint32_t period = (uint32_t)(((uint64_t)period_ns * HARDWARE_HZ + 500000000) / 1000000000);
    board.ticks = 0;
    board.reported = 0;
    board.clock = 0;
    board.count = hardware_start(period);
    return period;
}

/* Ticks that are due and that the last call of iso_port_wait did not report; less than 2^32. */
static uint32_t due(void)
{
    return board.ticks - (uint32_t)board.reported;
}

/* DUTY tick, jitter, catching up: returns when a tick is due that was not reported, with the number of the latest. If
 * several are due, it returns at once: the loop sees by the number that it missed some. It must neither return early,
 * nor report a tick twice, nor sleep through one. */
uint64_t iso_port_wait(void)
{
    uint32_t ticks = due();
    while (ticks == 0) {
        hardware_interrupts_off();
        if (due() == 0) {
            hardware_sleep();
        }
        hardware_interrupts_on();
        ticks = due();
    }
    board.reported += ticks;
    return board.reported;
}

/* DUTY clock, wrap: counts since the start, in 64 bits that never wrap and never go back: tick k is due at k times the
 * period. */
uint64_t iso_port_clock(void)
{
    hardware_interrupts_off();
    const uint64_t clock = looked();
    hardware_interrupts_on();
    return clock;
}

/* DUTY inputs: overwrites those of u[inputs] that the board measures, in SI units, in the order of the scene, and
 * nothing behind them. Called once in a tick, before the step: it should take the same time always. Start converters at
 * the end of iso_port_publish, so that they are done here. A measurement that failed leaves its input alone: the last
 * one holds. */
void iso_port_read(real *const u, const size_t inputs)
{
    (void)u;
    (void)inputs;
}

/* Hands y[outputs] to converters, a bus, pins: once in a tick, after the step. Limit each to the range of its
 * converter. */
void iso_port_publish(const real *const y, const size_t outputs)
{
    (void)y;
    (void)outputs;
}

/* The guard has stopped the plant: turn off everything that must not stay on. The last outputs were good ones; a board
 * without such a state does nothing. */
void iso_port_safe(void)
{
}

/* DUTY console: all bytes, in their order, none lost, whatever their value. Called between ticks. */
void iso_port_write(const void *const bytes, const size_t count)
{
    const uint8_t *const from = bytes;
    for (size_t i = 0; i < count; i++) {
        hardware_put(from[i]);
    }
}

/* DUTY duration. */
uint64_t iso_port_duration(const int argc, char **const argv)
{
    (void)argc;
    (void)argv;
    return hardware_duration();
}

/* DUTY exit: does not return. */
_Noreturn void iso_port_exit(const int status)
{
    hardware_end(status);
    for (;;) {
        hardware_sleep();
    }
}
