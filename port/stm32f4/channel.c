/* The serial lines as channels: USART6 on PC6 and PC7 to a controller, UART4 on PC10 and PC11 for calibration, at 460800 Bd.
 *
 * Interrupts move each byte between a line and a ring. A byte that comes while the ring is full, or before the one before it was
 * taken, is lost: the frames tell. QEMU 7.2 has no interrupt of a line that is empty: so what can go goes at once, too. */
#include "port/channel.h"

#include <string.h>

#include "port/ring.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/time.h"
#include "port/stm32f4/usart.h"

#define VTOR (*(const uint32_t *volatile *)0xE000ED08U)
#define NVIC_ISER ((volatile uint32_t *)0xE000E100U)

enum { EXCEPTIONS = 16, LAST_INTERRUPT = USART6_INTERRUPT, UART_FUNCTION = 8 };

static struct {
    ring in, out;
} lines[ISO_CHANNELS];
static usart_registers *const uarts[ISO_CHANNELS] = {
    [ISO_CHANNEL_CONTROLLER] = (usart_registers *)USART6_AT,
    [ISO_CHANNEL_CALIBRATION] = (usart_registers *)UART4_AT,
};

static void interrupts_off(void)
{
    __asm__ volatile("cpsid i" ::: "memory");
}

static void interrupts_on(void)
{
    __asm__ volatile("cpsie i\n    isb" ::: "memory");
}

/* From the line to its ring, and from the ring to the line: in the interrupt or with interrupts off. A full ring leaves a byte
 * where it is; the line interrupts when it is empty as long as there is something to send. */
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

static void let(const unsigned interrupt)
{
    NVIC_ISER[interrupt / 32] = UINT32_C(1) << interrupt % 32;
}

/* Opens all lines when the first is used: the table of exceptions gets those of the lines behind it. A table stands at a multiple
 * of its size, rounded up to a power of two. */
static void open_lines(void)
{
    static _Alignas(512) void (*table[EXCEPTIONS + LAST_INTERRUPT + 1])(void) = {
        [EXCEPTIONS + USART6_INTERRUPT] = controller_moves, [EXCEPTIONS + UART4_INTERRUPT] = calibration_moves};
    static bool is_open;
    if (is_open) {
        return;
    }
    is_open = true;
    memcpy(table, VTOR, EXCEPTIONS * sizeof table[0]);
    VTOR = (const uint32_t *)(uintptr_t)table;
    __asm__ volatile("dsb\n    isb" ::: "memory");
    rcc_registers *const rcc = (rcc_registers *)RCC_AT;
    rcc->apb1enr |= UART4_CLOCK;
    rcc->apb2enr |= USART6_CLOCK;
    for (unsigned pin = 6; pin < 12; pin += pin == 7 ? 3 : 1) {
        gpio_alternate('C', pin, UART_FUNCTION);
    }
    usart_start(uarts[ISO_CHANNEL_CONTROLLER], the_clock.tree.apb2_hz, USART_RX_INTERRUPT);
    usart_start(uarts[ISO_CHANNEL_CALIBRATION], the_clock.tree.apb1_hz, USART_RX_INTERRUPT);
    let(USART6_INTERRUPT);
    let(UART4_INTERRUPT);
}

size_t iso_port_receive(const iso_channel channel, void *const bytes, const size_t count)
{
    open_lines();
    const size_t taken = ring_take_all(&lines[channel].in, bytes, count);
    if (taken > 0) { /* there is room again */
        interrupts_off();
        move(channel);
        interrupts_on();
    }
    return taken;
}

/* A line does not show who is at its other end. */
uint32_t iso_port_opened(const iso_channel channel)
{
    (void)channel;
    return 0;
}

bool iso_port_send(const iso_channel channel, const void *const bytes, const size_t count)
{
    open_lines();
    if (!ring_put_all(&lines[channel].out, bytes, count)) {
        return false;
    }
    interrupts_off();
    move(channel);
    interrupts_on();
    return true;
}

/* Interrupts are held off between the look and the sleep; a pending one wakes the processor all the same. */
void iso_port_idle(void)
{
    open_lines();
    interrupts_off();
    bool came = false;
    for (unsigned channel = 0; channel < ISO_CHANNELS; channel++) {
        came = came || !ring_is_empty(&lines[channel].in);
    }
    if (!came) {
        time_idle();
    }
    interrupts_on();
}

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
