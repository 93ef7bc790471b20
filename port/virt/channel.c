/* The serial line of the board as the channel to a controller: a 16550, 8 bits, no parity, one stop bit; there is none
 * for calibration. QEMU keeps received bytes until they are read, and takes sent bytes at once; an interrupt wakes the
 * processor, and is never taken. Texas Instruments (2015), PC16550D Universal Asynchronous Receiver/Transmitter,
 * SNLS378C: 8. RISC-V (2023), RISC-V Platform-Level Interrupt Controller Specification, version 1.0.0: 3. */
#include "port/channel.h"

#include <stdint.h>

#include "port/ring.h"
#include "port/virt/tick.h"

#define UART ((volatile uint8_t *)0x10000000U)

enum { DATA = 0, INTERRUPTS = 1, FIFO_CONTROL = 2, LINE_CONTROL = 3, LINE_STATUS = 5 };
enum { FIFOS_ON = 1 << 0, EIGHT_BITS = 3, IS_FULL = 1 << 0, IS_EMPTY = 1 << 5, RECEIVED = 1 << 0 };

/* The interrupt controller: the priority of the line, the enabled interrupts of the first processor, and the claimed
 * one. */
#define PLIC(offset) (*(volatile uint32_t *)(0x0C000000U + (offset)))
enum { LINE = 10, PRIORITY = 4 * LINE, ENABLED = 0x2000, THRESHOLD = 0x200000, CLAIM = 0x200004 };

/* The bit of mie. */
enum { EXTERNAL_ON = 1 << 11 };

enum { LINES_INTERRUPT = false };

/* Sends each byte when there is room for it: in QEMU that is at once. */
static void move(const iso_channel channel)
{
    ring *const in = &lines[channel].in, *const out = &lines[channel].out;
    while (channel == ISO_CHANNEL_CONTROLLER && (UART[LINE_STATUS] & IS_FULL) != 0 && !ring_is_full(in)) {
        ring_put(in, UART[DATA]);
    }
    while (channel == ISO_CHANNEL_CONTROLLER && !ring_is_empty(out)) {
        while ((UART[LINE_STATUS] & IS_EMPTY) == 0) {
        }
        UART[DATA] = ring_take(out);
    }
}

static void start_lines(void)
{
    UART[LINE_CONTROL] = EIGHT_BITS;
    UART[FIFO_CONTROL] = FIFOS_ON;
    UART[INTERRUPTS] = RECEIVED;
    PLIC(PRIORITY) = 1;
    PLIC(ENABLED) = 1U << LINE;
    PLIC(THRESHOLD) = 0;
}

/* Time is virtual, and stands still: the ticks are moved by as long as the processor slept. */
static void sleep(void)
{
    const uint64_t begin = tick_timer();
    uint32_t enabled;
    __asm__ volatile("csrrw %0, mie, %1" : "=r"(enabled) : "r"(EXTERNAL_ON) : "memory");
    __asm__ volatile("wfi" ::: "memory");
    PLIC(CLAIM) = PLIC(CLAIM);
    __asm__ volatile("csrw mie, %0" ::"r"(enabled) : "memory");
    tick_pause(tick_timer() - begin);
}

#include "port/lines.h"

/* All sent bytes have left the line. */
void iso_port_drain(void)
{
}
