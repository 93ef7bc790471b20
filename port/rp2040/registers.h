/* Registers of the RP2040. RP2040 Datasheet: 2.2 addresses, 2.1.2 atomic access, 2.14.3 RESETS, 2.15.7 CLOCKS, 2.16.7
 * XOSC, 2.18.4 PLL, 2.19.6 pins, 4.2.8 UART. Armv6-M Architecture Reference Manual, DDI 0419E: B3.3 SysTick. */
#ifndef ISO_PORT_RP2040_REGISTERS_H
#define ISO_PORT_RP2040_REGISTERS_H

#include <stdint.h>

typedef volatile uint32_t *registers;

/* A write there sets or clears the bits that it has. */
enum { SETS = 0x2000 / 4, CLEARS = 0x3000 / 4 };

/* Units, and the words of their registers. */
#define CLOCKS ((registers)0x40008000U)
enum { CLK_REF_CTRL = 0x30 / 4, CLK_REF_SELECTED = 0x38 / 4, CLK_SYS_CTRL = 0x3C / 4, CLK_SYS_SELECTED = 0x44 / 4 };
enum {
    CLK_PERI_CTRL = 0x48 / 4,
    CLK_ADC_CTRL = 0x60 / 4,
    CLK_ON = 1 << 11,
    FROM_CRYSTAL = 2,
    FROM_REFERENCE = 0,
    FROM_PLL = 1
};

#define RESETS ((registers)0x4000C000U)
enum { RESET_DONE = 8 / 4 };
enum {
    UNIT_ADC = 1 << 0,
    UNIT_DMA = 1 << 2,
    UNIT_IO = 1 << 5,
    UNIT_PADS = 1 << 8,
    UNIT_PIO0 = 1 << 10,
    UNIT_PIO1 = 1 << 11,
    UNIT_PLL_SYS = 1 << 12,
    UNIT_PLL_USB = 1 << 13,
    UNIT_PWM = 1 << 14,
    UNIT_UART0 = 1 << 22,
    UNIT_UART1 = 1 << 23
};

#define IO ((registers)0x40014000U)   /* a pin: status, control */
#define PADS ((registers)0x4001C000U) /* behind the first word, one for each pin */
enum {
    FUNCTION_UART = 2,
    FUNCTION_PWM = 4,
    FUNCTION_SIO = 5,
    FUNCTION_PIO0 = 6,
    FUNCTION_PIO1 = 7,
    FUNCTION_NONE = 31
};
enum {
    PAD_SCHMITT = 1 << 1,
    PAD_PULL_DOWN = 1 << 2,
    PAD_PULL_UP = 1 << 3,
    PAD_4_MA = 1 << 4,
    PAD_INPUT = 1 << 6,
    PAD_NO_OUTPUT = 1 << 7
};

#define XOSC ((registers)0x40024000U)
enum { XOSC_CTRL = 0, XOSC_STATUS = 4 / 4, XOSC_STARTUP = 0xC / 4 };
enum { XOSC_1_TO_15_MHZ = 0xAA0, XOSC_ENABLE = 0xFAB << 12 };
#define IS_STABLE (UINT32_C(1) << 31)

#define PLL_SYS ((registers)0x40028000U)
#define PLL_USB ((registers)0x4002C000U)
enum { PLL_CS = 0, PLL_POWER = 4 / 4, PLL_FACTOR = 8 / 4, PLL_DIVIDERS = 0xC / 4 };
enum { PLL_OFF = 1 << 0, PLL_DIVIDERS_OFF = 1 << 3, PLL_VCO_OFF = 1 << 5, DIVIDER_1_AT = 16, DIVIDER_2_AT = 12 };

#define UART0 ((registers)0x40034000U)
#define UART1 ((registers)0x40038000U)
enum { UART_DATA = 0, UART_FLAGS = 0x18 / 4, UART_WHOLE = 0x24 / 4, UART_64THS = 0x28 / 4, UART_LINE = 0x2C / 4 };
enum { UART_CONTROL = 0x30 / 4, UART_INTERRUPTS = 0x38 / 4, UART_CLEAR = 0x44 / 4 };
enum { UART_BUSY = 1 << 3, UART_RX_EMPTY = 1 << 4, UART_TX_FULL = 1 << 5 };
enum { UART_8_BITS = 3 << 5, UART_FIFOS = 1 << 4, UART_ON = 1 << 0, UART_TX_ON = 1 << 8, UART_RX_ON = 1 << 9 };
/* A level of the received bytes, some bytes and then silence, and a level of the bytes to send. */
enum { UART_RECEIVED = 1 << 4, UART_TX_LOW = 1 << 5, UART_SILENT = 1 << 6 };
enum { UART0_INTERRUPT = 20, UART1_INTERRUPT = 21, INTERRUPTS = 26 };

/* Of the processor. */
#define SYSTICK ((registers)0xE000E010U)
enum { SYSTICK_CSR = 0, SYSTICK_RVR = 1, SYSTICK_CVR = 2, SYSTICK_RUN = 7, SYSTICK_STOP = 6, SYSTICK_COUNTS = 1 << 24 };
#define ICSR (*(registers)0xE000ED04U)
#define VTOR (*(volatile uintptr_t *)0xE000ED08U)
enum { SYSTICK_PENDING = 1 << 26 };

/* What the board is: a crystal of 12 MHz, of which the PLL makes 1500 MHz and then the clock of the system. */
enum { CRYSTAL_MHZ = 12, SYSTEM_MHZ = 125, VCO_MHZ = 1500, CRYSTAL_START_US = 1000 };

/* Resets units, and waits until they are ready. */
static inline void units_start(const uint32_t units)
{
    RESETS[SETS] = units;
    RESETS[CLEARS] = units;
    while ((RESETS[RESET_DONE] & units) != units) {
    }
}

/* A pin, with the setting of its pad, as a part of a unit. */
static inline void pin_use(const unsigned pin, const uint32_t pad, const uint32_t function)
{
    PADS[1 + pin] = pad;
    IO[2 * pin + 1] = function;
}

/* A serial line of 8 bits on two pins, the first of which sends: a bit lasts so many 64ths of 16 clocks of the system.
 * A line that nothing is joined to is idle. */
static inline void uart_start(const registers uart, const uint32_t unit, const unsigned first_pin, const uint32_t baud)
{
    const uint32_t divider = (4 * SYSTEM_MHZ * UINT32_C(1000000) + baud / 2) / baud;
    units_start(unit);
    uart[UART_WHOLE] = divider / 64;
    uart[UART_64THS] = divider % 64;
    uart[UART_LINE] = UART_8_BITS | UART_FIFOS;
    uart[UART_CONTROL] = UART_ON | UART_TX_ON | UART_RX_ON;
    for (unsigned pin = first_pin; pin < first_pin + 2; pin++) {
        pin_use(pin, PAD_INPUT | PAD_4_MA | PAD_PULL_UP | PAD_SCHMITT, FUNCTION_UART);
    }
}

#endif
