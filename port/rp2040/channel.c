/* The serial line to a controller: UART1 on GPIO4 (out) and GPIO5 (in) at 3 MBd; there is none for calibration.
 *
 * Interrupts move each byte between the line and a ring. A byte that comes while the ring and the line's own 32 bytes
 * are full is lost: the frames show it. */
#include "port/channel.h"

#include "port/mps2/interrupts.h"
#include "port/ring.h"
#include "port/rp2040/registers.h"
#include "port/rp2040/start.h"

enum { LINES_INTERRUPT = 1, LINE_BAUD = 3000000, LINE_PIN = 4 };

/* From the line to its ring, and from the ring to the line: in the interrupt or with interrupts off. A full ring leaves
 * a byte where it is; the line interrupts when it has room as long as there is something to send. */
static void move(const iso_channel channel)
{
    ring *const in = &lines[channel].in, *const out = &lines[channel].out;
    if (channel != ISO_CHANNEL_CONTROLLER) {
        return;
    }
    while ((UART1[UART_FLAGS] & UART_RX_EMPTY) == 0 && !ring_is_full(in)) {
        ring_put(in, (uint8_t)UART1[UART_DATA]);
    }
    while ((UART1[UART_FLAGS] & UART_TX_FULL) == 0 && !ring_is_empty(out)) {
        UART1[UART_DATA] = ring_take(out);
    }
    const uint32_t in_room = ring_is_full(in) ? 0 : UART_RECEIVED | UART_SILENT;
    const uint32_t out_waits = ring_is_empty(out) ? 0 : UART_TX_LOW;
    UART1[UART_INTERRUPTS] = in_room | out_waits;
}

static void line_moves(void)
{
    UART1[UART_CLEAR] = UART_RECEIVED | UART_SILENT | UART_TX_LOW;
    move(ISO_CHANNEL_CONTROLLER);
}

static void start_lines(void)
{
    the_handlers[EXCEPTIONS + UART1_INTERRUPT] = line_moves;
    uart_start(UART1, UNIT_UART1, LINE_PIN, LINE_BAUD);
    UART1[UART_INTERRUPTS] = UART_RECEIVED | UART_SILENT;
    interrupts_let(UART1_INTERRUPT);
}

/* In the emulator the time of the board stands still meanwhile. */
static void sleep(void)
{
    if (start_is_emulated()) {
        SYSTICK[SYSTICK_CSR] = SYSTICK_STOP;
    }
    __asm__ volatile("wfi" ::: "memory");
    if (start_is_emulated()) {
        SYSTICK[SYSTICK_CSR] = SYSTICK_RUN;
    }
}

#include "port/lines.h"

/* The next tick wakes the processor at the latest; then the last bytes are on their way. */
void iso_port_drain(void)
{
    while (!ring_is_empty(&lines[ISO_CHANNEL_CONTROLLER].out)) {
        __asm__ volatile("wfi" ::: "memory");
    }
    while ((UART1[UART_FLAGS] & UART_BUSY) != 0) {
    }
}
