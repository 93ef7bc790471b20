/* Serial lines. RM0090 30.6, RM0390 25.6: the same registers. 8 bits, no parity, one stop bit. */
#ifndef ISO_PORT_STM32F4_USART_H
#define ISO_PORT_STM32F4_USART_H

#include <stdint.h>

typedef struct usart_registers {
    volatile uint32_t sr, dr, brr, cr1, cr2, cr3, gtpr;
} usart_registers;

#define USART2_AT UINT32_C(0x40004400)
#define UART4_AT UINT32_C(0x40004C00)
#define USART6_AT UINT32_C(0x40011400)
enum { USART2_INTERRUPT = 38, UART4_INTERRUPT = 52, USART6_INTERRUPT = 71 };

/* Status; control 1. */
enum { USART_RECEIVED = 1 << 5, USART_COMPLETE = 1 << 6, USART_EMPTY = 1 << 7 };
enum {
    USART_RX_ON = 1 << 2,
    USART_TX_ON = 1 << 3,
    USART_RX_INTERRUPT = 1 << 5,
    USART_TX_INTERRUPT = 1 << 7,
    USART_ON = 1 << 13
};

enum { USART_BAUD = 460800 };

/* The divider: sixteenths of 16 samples a bit are counts of the bus (RM0090, 30.3.4). */
static inline uint32_t usart_divider(const uint32_t bus_hz)
{
    return (bus_hz + USART_BAUD / 2) / USART_BAUD;
}

static inline void usart_start(usart_registers *const u, const uint32_t bus_hz, const uint32_t interrupts)
{
    u->brr = usart_divider(bus_hz);
    u->cr1 = USART_ON | USART_TX_ON | USART_RX_ON | interrupts;
}

/* Waits until there is room. */
static inline void usart_put(usart_registers *const u, const uint8_t byte)
{
    while ((u->sr & USART_EMPTY) == 0) {
    }
    u->dr = byte;
}

#endif
