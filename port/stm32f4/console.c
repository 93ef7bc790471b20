/* From reset to main: the clock tree and the console, USART2 on PA2 and PA3. The duration is in QEMU on the command
 * line, on silicon in two symbols of the linker (port.mk). At the end QEMU gets the status; silicon rests. */
#include "port/mps2/semihosting.h"
#include "port/mps2/start.h"
#include "port/port.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/pins.h"
#include "port/stm32f4/usart.h"

/* From the linker: halves of a duration, as addresses. */
extern const uint8_t run_ns_high[], run_ns_low[];

enum { USART2_FUNCTION = 7 };

static usart_registers *const console = (usart_registers *)USART2_AT;

int start_platform(char **const words, const int max)
{
    clock_start();
    ((rcc_registers *)RCC_AT)->apb1enr |= USART2_CLOCK;
    gpio_alternate('A', 2, USART2_FUNCTION);
    gpio_alternate('A', 3, USART2_FUNCTION);
    usart_start(console, the_clock.tree.apb1_hz, 0);
    return the_clock.source == CLOCK_NONE ? semihosting_arguments(words, max) : 0;
}

void iso_port_write(const void *const bytes, const size_t count)
{
    const uint8_t *const from = bytes;
    for (size_t i = 0; i < count; i++) {
        usart_put(console, from[i]);
    }
}

static void say(const char *const text)
{
    for (const char *c = text; *c != '\0'; c++) {
        usart_put(console, (uint8_t)*c);
    }
}

__attribute__((cold)) uint64_t iso_port_duration(const int argc, char **const argv)
{
    const char *const error = pins_start();
    if (error != NULL) {
        say("Bail out! the table of pins: ");
        say(error);
        say("\n");
        iso_port_exit(1);
    }
    uint64_t duration = (uint64_t)(uintptr_t)run_ns_high << 32 | (uintptr_t)run_ns_low;
    if (argc > 1) {
        duration = 0;
        for (const char *digit = argv[1]; *digit >= '0' && *digit <= '9'; digit++) {
            duration = duration * 10 + (uint64_t)(*digit - '0');
        }
    }
    return duration;
}

_Noreturn void iso_port_exit(const int status)
{
    while ((console->sr & USART_COMPLETE) == 0) {
    }
    if (the_clock.source == CLOCK_NONE) {
        semihosting_exit(status);
    }
    for (;;) {
        __asm__ volatile("cpsid i\n    wfi" ::: "memory");
    }
}
