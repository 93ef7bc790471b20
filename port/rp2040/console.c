/* The console, UART0 on GPIO0 (out) and GPIO1 (in) at 460800 Bd, the duration of a run, and its end. */
#include "port/mps2/interrupts.h"
#include "port/port.h"
#include "port/rp2040/pins.h"
#include "port/rp2040/registers.h"
#include "port/rp2040/start.h"

enum { CONSOLE_BAUD = 460800, CONSOLE_PIN = 0 };

static void console_put(const uint8_t byte)
{
    while ((UART0[UART_FLAGS] & UART_TX_FULL) != 0) {
    }
    UART0[UART_DATA] = byte;
}

void iso_port_write(const void *const bytes, const size_t count)
{
    const uint8_t *const from = bytes;
    for (size_t i = 0; i < count; i++) {
        console_put(from[i]);
    }
}

static void say(const char *const text)
{
    for (const char *c = text; *c != 0; c++) {
        console_put((uint8_t)*c);
    }
}

__attribute__((cold)) void start_tell(const char *const error)
{
    if (error != NULL) {
        say("Bail out! the table of pins: ");
        say(error);
        say("\n");
        iso_port_exit(1);
    }
}

/* The first function of the port that a program calls. */
__attribute__((cold)) uint64_t iso_port_duration(const int argc, char **const argv)
{
    (void)argc;
    (void)argv;
    units_start(UNIT_IO | UNIT_PADS);
    uart_start(UART0, UNIT_UART0, CONSOLE_PIN, CONSOLE_BAUD);
    start_tell(pins_start());
    return start_run_ns();
}

/* A debugger, or the emulator, finds the status in a register that keeps it: 0x49534F00 and the status. RP2040
 * Datasheet, 4.7.6 WATCHDOG: SCRATCH0. */
_Noreturn void iso_port_exit(const int status)
{
    while ((UART0[UART_FLAGS] & UART_BUSY) != 0) {
    }
    interrupts_off();
    *(registers)0x4005800CU = UINT32_C(0x49534F00) | ((uint32_t)status & 0xFF);
    for (;;) {
        __asm__ volatile("wfi" ::: "memory");
    }
}
