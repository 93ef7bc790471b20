/* The serial lines as channels: USART6 on PC6 and PC7 to a controller, UART4 on PC10 and PC11 for calibration, at
 * 460800 Bd.
 *
 * Interrupts move each byte between a line and a ring. A byte that comes while the ring is full, or before the one
 * before it was taken, is lost: the frames show it. QEMU 7.2 has no interrupt of a line that is empty: so bytes are
 * also sent at once, where there is room. */
#include "port/channel.h"

#include "port/mps2/interrupts.h"
#include "port/ring.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/time.h"
#include "port/stm32f4/usart.h"

enum { LINES_INTERRUPT = true, LAST_INTERRUPT = USART6_INTERRUPT, UART_FUNCTION = 8 };

static usart_registers *const uarts[ISO_CHANNELS] = {
    [ISO_CHANNEL_CONTROLLER] = (usart_registers *)USART6_AT,
    [ISO_CHANNEL_CALIBRATION] = (usart_registers *)UART4_AT,
};

/* From the line to its ring, and from the ring to the line: in the interrupt or with interrupts off. A full ring leaves
 * a byte where it is; the line interrupts when it is empty as long as there is something to send. */
static void move(const iso_channel channel)
{
    usart_registers *const u = uarts[channel];
    while ((u->sr & USART_RECEIVED) != 0 && !ring_is_full(&lines[channel].in)) {
        ring_put(&lines[channel].in, (uint8_t)u->dr);
    }
    while ((u->sr & USART_EMPTY) != 0 && !ring_is_empty(&lines[channel].out)) {
        u->dr = ring_take(&lines[channel].out);
    }
    const uint32_t always = USART_ON | USART_TX_ON | USART_RX_ON;
    u->cr1 = always | (ring_is_full(&lines[channel].in) ? 0 : (uint32_t)USART_RX_INTERRUPT) |
             (ring_is_empty(&lines[channel].out) ? 0 : (uint32_t)USART_TX_INTERRUPT);
}

static void controller_moves(void)
{
    move(ISO_CHANNEL_CONTROLLER);
}

static void calibration_moves(void)
{
    move(ISO_CHANNEL_CALIBRATION);
}

/* The table of exceptions gets those of the lines. */
static void start_lines(void)
{
    static _Alignas(512) interrupt_handler *table[EXCEPTIONS + LAST_INTERRUPT + 1] = {
        [EXCEPTIONS + USART6_INTERRUPT] = controller_moves, [EXCEPTIONS + UART4_INTERRUPT] = calibration_moves};
    interrupts_table(table);
    rcc_registers *const rcc = (rcc_registers *)RCC_AT;
    rcc->apb1enr |= UART4_CLOCK;
    rcc->apb2enr |= USART6_CLOCK;
    for (unsigned pin = 6; pin < 12; pin += pin == 7 ? 3 : 1) {
        gpio_alternate('C', pin, UART_FUNCTION);
    }
    usart_start(uarts[ISO_CHANNEL_CONTROLLER], the_clock.tree.apb2_hz, USART_RX_INTERRUPT);
    usart_start(uarts[ISO_CHANNEL_CALIBRATION], the_clock.tree.apb1_hz, USART_RX_INTERRUPT);
    interrupts_let(USART6_INTERRUPT);
    interrupts_let(UART4_INTERRUPT);
}

static void sleep(void)
{
    time_idle();
}

#include "port/lines.h"

/* The next tick wakes the processor at the latest; then the last byte is on its way. */
void iso_port_drain(void)
{
    for (unsigned channel = 0; channel < ISO_CHANNELS; channel++) {
        while (!ring_is_empty(&lines[channel].out)) {
            __asm__ volatile("wfi" ::: "memory");
        }
        while ((uarts[channel]->sr & USART_COMPLETE) == 0) {
        }
    }
}
