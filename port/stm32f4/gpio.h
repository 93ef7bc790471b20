/* Pins: the function of each. RM0090 8.4, RM0390 7.4; the numbers of alternate functions are in the data sheets. */
#ifndef ISO_PORT_STM32F4_GPIO_H
#define ISO_PORT_STM32F4_GPIO_H

#include <stdint.h>

#include "port/stm32f4/clock.h"

typedef struct gpio_registers {
    volatile uint32_t moder, otyper, ospeedr, pupdr, idr, odr, bsrr, lckr, afr[2];
} gpio_registers;

#define GPIO_AT UINT32_C(0x40020000) /* port A; each further one 0x400 behind */
enum { GPIO_STRIDE = 0x400, GPIO_ALTERNATE = 2, GPIO_ANALOGUE = 3, GPIO_PULL_UP = 1, GPIO_FAST = 2 };

/* A pin by its letter and number, such as 'A', 5. */
static inline gpio_registers *gpio_of(const char port)
{
    const uint32_t number = (uint32_t)(port - 'A');
    ((rcc_registers *)RCC_AT)->ahb1enr |= UINT32_C(1) << number;
    return (gpio_registers *)(uintptr_t)(GPIO_AT + GPIO_STRIDE * number);
}

static inline void gpio_set(volatile uint32_t *const field, const unsigned bits, const unsigned pin,
                            const uint32_t value)
{
    const uint32_t mask = (UINT32_C(1) << bits) - 1;
    *field = (*field & ~(mask << bits * pin)) | value << bits * pin;
}

static inline void gpio_analogue(const char port, const unsigned pin)
{
    gpio_set(&gpio_of(port)->moder, 2, pin, GPIO_ANALOGUE);
}

/* Pulled up, so that a line that nothing is joined to is idle. */
static inline void gpio_alternate(const char port, const unsigned pin, const uint32_t function)
{
    gpio_registers *const g = gpio_of(port);
    gpio_set(&g->afr[pin / 8], 4, pin % 8, function);
    gpio_set(&g->ospeedr, 2, pin, GPIO_FAST);
    gpio_set(&g->pupdr, 2, pin, GPIO_PULL_UP);
    gpio_set(&g->moder, 2, pin, GPIO_ALTERNATE);
}

#endif
