/* The serial lines as channels: UART0 to a controller, UART1 for calibration, at 1 MBd, 8 bits, no parity, one stop
 * bit.
 *
 * Interrupts move each byte between a line and a ring, so that no byte waits for a tick. A line whose ring is full
 * leaves bytes where they are; on silicon these are then lost, in QEMU the sender waits. Arm (2015), Cortex-M System
 * Design Kit, DDI 0479D: 4.3 APB UART. Arm (2016), Application Note AN386: interrupts. */
#include "port/channel.h"

#include <stdint.h>

#include "port/mps2/board.h"
#include "port/mps2/interrupts.h"
#include "port/mps2/tick.h"
#include "port/ring.h"

typedef struct uart {
    uint32_t data;
    uint32_t state;
    uint32_t control;
    uint32_t interrupt; /* the pending ones; writing a bit clears it */
    uint32_t divider;
} uart;

enum { TX_FULL = 1 << 0, RX_FULL = 1 << 1 };
enum { TX_ON = 1 << 0, RX_ON = 1 << 1, TX_INTERRUPT_ON = 1 << 2, RX_INTERRUPT_ON = 1 << 3 };
enum { TX_PENDING = 1 << 0, RX_PENDING = 1 << 1 };
enum { BOTH_ON = TX_ON | RX_ON | TX_INTERRUPT_ON | RX_INTERRUPT_ON };

/* Counts of the clock for a bit. */
enum { BIT_COUNTS = BOARD_MHZ };

/* Four interrupts: of UART0 receive and transmit, then of UART1. They stand behind the exceptions, and those before
 * them. */
enum { LINES_INTERRUPT = true, INTERRUPTS = 4, FIRST = EXCEPTIONS + BOARD_FIRST_INTERRUPT };

static volatile uart *const uarts[ISO_CHANNELS] = {
    [ISO_CHANNEL_CONTROLLER] = (volatile uart *)BOARD_UART0,
    [ISO_CHANNEL_CALIBRATION] = (volatile uart *)BOARD_UART1,
};

/* From the line to its ring, in the interrupt or with interrupts off. */
static void move_in(const iso_channel channel)
{
    while ((uarts[channel]->state & RX_FULL) != 0 && !ring_is_full(&lines[channel].in)) {
        ring_put(&lines[channel].in, (uint8_t)uarts[channel]->data);
    }
}

/* From the ring to the line, likewise. */
static void move_out(const iso_channel channel)
{
    while ((uarts[channel]->state & TX_FULL) == 0 && !ring_is_empty(&lines[channel].out)) {
        uarts[channel]->data = ring_take(&lines[channel].out);
    }
}

static void move(const iso_channel channel)
{
    move_in(channel);
    move_out(channel);
}

static void received(const iso_channel channel)
{
    uarts[channel]->interrupt = RX_PENDING;
    move_in(channel);
}

static void transmitted(const iso_channel channel)
{
    uarts[channel]->interrupt = TX_PENDING;
    move_out(channel);
}

static void controller_received(void)
{
    received(ISO_CHANNEL_CONTROLLER);
}

static void controller_transmitted(void)
{
    transmitted(ISO_CHANNEL_CONTROLLER);
}

static void calibration_received(void)
{
    received(ISO_CHANNEL_CALIBRATION);
}

static void calibration_transmitted(void)
{
    transmitted(ISO_CHANNEL_CALIBRATION);
}

/* The table of exceptions gets those of the lines. */
static void start_lines(void)
{
    static _Alignas(256) interrupt_handler *table[FIRST + INTERRUPTS] = {
        [FIRST] = controller_received, controller_transmitted, calibration_received, calibration_transmitted};
    interrupts_table(table);
    for (unsigned channel = 0; channel < ISO_CHANNELS; channel++) {
        uarts[channel]->divider = BIT_COUNTS;
        uarts[channel]->control = BOTH_ON;
    }
    for (unsigned i = 0; i < INTERRUPTS; i++) {
        interrupts_let(BOARD_FIRST_INTERRUPT + i);
    }
}

/* Time is virtual, and stands still: QEMU would else go from tick to tick as fast as it can, and serve the lines
 * between. */
static void sleep(void)
{
    SYST_CSR = SYST_CSR_STOP;
    __asm__ volatile("wfi" ::: "memory");
    SYST_CSR = SYST_CSR_RUN;
}

#include "port/lines.h"

/* The next tick wakes the processor at the latest. */
void iso_port_drain(void)
{
    for (unsigned channel = 0; channel < ISO_CHANNELS; channel++) {
        while (!ring_is_empty(&lines[channel].out)) {
            __asm__ volatile("wfi" ::: "memory");
        }
    }
}
