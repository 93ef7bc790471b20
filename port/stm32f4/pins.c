#include "port/stm32f4/pins.h"

#include "port/pins/table.h"
#include "port/port.h"
#include "port/stm32f4/adc.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/dac.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/timer.h"

enum { DAC_CHANNELS = 2, TIM3_FUNCTION = 2 };

static char port_of(const pins_row *const row)
{
    return (char)('A' + row->pin / PINS_OF_A_PORT);
}

static unsigned pin_of(const pins_row *const row)
{
    return row->pin % PINS_OF_A_PORT;
}

/* 0 and 1: the converter to voltages; 2 to 5: pulse widths; -1: a pin that shows nothing. */
static int channel_of(const pins_row *const row)
{
    const unsigned pin = pin_of(row);
    return port_of(row) == 'A' && pin >= 4 && pin < 8 ? (int)pin - 4
           : port_of(row) == 'B' && pin < 2           ? 4 + (int)pin
                                                      : -1;
}

const char *pins_lacks(const pins_row *const row, const bool is_output)
{
    const unsigned pin = pin_of(row);
    if (!is_output && row->kind != PINS_VOLTAGE) {
        return "an input that is no voltage: this port measures no duty, edges, levels or quadrature yet";
    }
    if (!is_output && adc_channel(port_of(row), pin) < 0) {
        return "an input is on a pin without a converter: PA0 to PA7, PB0, PB1 and PC0 to PC5 have one";
    }
    if (!is_output && port_of(row) == 'A' && (pin == 2 || pin == 3)) {
        return "an input is on PA2 or PA3, which are the console's";
    }
    if (is_output && row->kind != PINS_VOLTAGE && row->kind != PINS_DUTY) {
        return "an output that is no voltage and no duty: this port shows no levels, edges or quadrature yet";
    }
    if (is_output && (channel_of(row) < 0 || (channel_of(row) < DAC_CHANNELS) != (row->kind == PINS_VOLTAGE))) {
        return "an output is on a pin that cannot show it: PA4 and PA5 show voltages, PA6, PA7, PB0 and PB1 duties";
    }
    return NULL;
}

const char *pins_clash(const pins_row *const a, const bool a_is_output, const pins_row *const b, const bool b_is_output)
{
    (void)a;
    (void)a_is_output;
    (void)b;
    (void)b_is_output;
    return NULL;
}

/* All channels of the timer count to the same period, and begin at 0. It counts at the clock of its bus, or at twice
 * that where the bus is slower than the core (RM0090 7.2, RM0390 6.2). */
static void start_pulses(timer_registers *const timer)
{
    const clock_tree *const t = &the_clock.tree;
    timer->arr = (t->apb1_hz == t->hz ? t->hz : 2 * t->apb1_hz) / PWM_HZ - 1;
    for (unsigned pair = 0; pair < 2; pair++) {
        timer->ccmr[pair] = (CHANNEL_MODE_1 | CHANNEL_PRELOAD) << 8 | CHANNEL_MODE_1 | CHANNEL_PRELOAD;
    }
    timer->egr = TIMER_TAKE_OVER;
    timer->cr1 = TIMER_ON | TIMER_RELOAD;
}

/* The converters and the timer, before the first pin. */
static void start_units(void)
{
    rcc_registers *const rcc = (rcc_registers *)RCC_AT;
    adc_registers *const adc = (adc_registers *)ADC1_AT;
    rcc->apb1enr |= TIM3_CLOCK | DAC_CLOCK;
    rcc->apb2enr |= ADC1_CLOCK;
    *(volatile uint32_t *)ADC_CCR_AT = ADC_BY_4;
    adc->smpr1 = ADC_SAMPLE_15;
    adc->smpr2 = ADC_SAMPLE_15;
    adc->cr2 = ADC_ON;
    start_pulses((timer_registers *)TIM3_AT);
}

const char *pins_open(const pins_row *const row, const size_t number, const bool is_output)
{
    static bool is_on;
    if (!is_on) {
        is_on = true;
        start_units();
    }
    if (!is_output) {
        gpio_analogue(port_of(row), pin_of(row));
        return NULL;
    }
    pins_show(row, number, row->safe);
    const int channel = channel_of(row);
    if (channel < DAC_CHANNELS) {
        gpio_analogue(port_of(row), pin_of(row));
        ((dac_registers *)DAC_AT)->cr |= channel == 0 ? DAC_1_ON : DAC_2_ON;
    } else {
        ((timer_registers *)TIM3_AT)->ccer |= UINT32_C(1) << 4 * (channel - DAC_CHANNELS);
        gpio_alternate(port_of(row), pin_of(row), TIM3_FUNCTION);
    }
    return NULL;
}

bool pins_measure(const pins_row *const row, const size_t number, real *const v)
{
    (void)number;
    uint32_t value = 0;
    const bool is_there =
        adc_measure((adc_registers *)ADC1_AT, (uint32_t)adc_channel(port_of(row), pin_of(row)), &value);
    *v = (real)value / R(4095.0);
    return is_there;
}

void pins_show(const pins_row *const row, const size_t number, const real v)
{
    (void)number;
    const int channel = channel_of(row);
    if (channel < DAC_CHANNELS) {
        ((dac_registers *)DAC_AT)->channels[channel].right_12 = (uint32_t)(v * R(4095.0) + R(0.5));
    } else {
        timer_registers *const timer = (timer_registers *)TIM3_AT;
        timer->ccr[channel - DAC_CHANNELS] = (uint32_t)(v * (real)(timer->arr + 1));
    }
}

void iso_port_read(real *const u, const size_t count)
{
    pins_read(u, count);
}

void iso_port_publish(const real *const y, const size_t count)
{
    pins_publish(y, count);
}

void iso_port_safe(void)
{
    pins_safe();
}
