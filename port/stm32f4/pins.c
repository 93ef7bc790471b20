#include "port/stm32f4/pins.h"

#include "port/port.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/dac.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/timer.h"

/* The row behind the last has no pin. */
static const pins_input inputs[] = {
#ifdef PINS_INPUTS
    PINS_INPUTS,
#endif
    {.port = 0}};
static const pins_output outputs[] = {
#ifdef PINS_OUTPUTS
    PINS_OUTPUTS,
#endif
    {.port = 0}};
static const size_t input_rows = sizeof inputs / sizeof inputs[0] - 1,
                    output_rows = sizeof outputs / sizeof outputs[0] - 1;
enum { DAC_CHANNELS = 2, TIM3_FUNCTION = 2 };

const char *pins_error(const pins_input *const in, const size_t input_count, const pins_output *const out,
                       const size_t output_count)
{
    for (size_t i = 0; i < input_count; i++) {
        if (adc_channel(in[i].port, in[i].pin) < 0) {
            return "an input is on a pin without a converter: PA0 to PA7, PB0, PB1 and PC0 to PC5 have one";
        }
        if (in[i].port == 'A' && (in[i].pin == 2 || in[i].pin == 3)) {
            return "an input is on PA2 or PA3, which are the console's";
        }
        for (size_t k = 0; k < i; k++) {
            if (in[k].input == in[i].input) {
                return "an input is on two pins";
            }
        }
    }
    for (size_t i = 0; i < output_count; i++) {
        if (pins_channel(out[i].port, out[i].pin) < 0) {
            return "an output is on a pin that cannot show it: PA4 and PA5 show voltages, PA6, PA7, PB0 and PB1 widths "
                   "of pulses";
        }
        if (!(out[i].at_0 < out[i].at_full || out[i].at_0 > out[i].at_full) ||
            !(out[i].safe >= 0 && out[i].safe <= 1)) {
            return "an output needs two numbers that differ, at_0 and at_full, and safe from 0 to 1";
        }
        for (size_t k = 0; k < i; k++) {
            if (out[k].port == out[i].port && out[k].pin == out[i].pin) {
                return "a pin shows two outputs";
            }
        }
        for (size_t k = 0; k < input_count; k++) {
            if (in[k].port == out[i].port && in[k].pin == out[i].pin) {
                return "a pin measures an input and shows an output";
            }
        }
    }
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

/* Shows a part of all, from 0 to 1. */
static void show(const pins_output *const o, const real part)
{
    const unsigned channel = (unsigned)pins_channel(o->port, o->pin);
    const real limited = iso_clamp(part, R(0.0), R(1.0));
    if (channel < DAC_CHANNELS) {
        ((dac_registers *)DAC_AT)->channels[channel].right_12 = (uint32_t)(limited * R(4095.0) + R(0.5));
    } else {
        timer_registers *const timer = (timer_registers *)TIM3_AT;
        timer->ccr[channel - DAC_CHANNELS] = (uint32_t)(limited * (real)(timer->arr + 1));
    }
}

const char *pins_start(void)
{
    const char *const error = pins_error(inputs, input_rows, outputs, output_rows);
    if (error != NULL || input_rows + output_rows == 0) {
        return error;
    }
    rcc_registers *const rcc = (rcc_registers *)RCC_AT;
    timer_registers *const timer = (timer_registers *)TIM3_AT;
    adc_registers *const adc = (adc_registers *)ADC1_AT;
    rcc->apb1enr |= TIM3_CLOCK | DAC_CLOCK;
    rcc->apb2enr |= ADC1_CLOCK;
    *(volatile uint32_t *)ADC_CCR_AT = ADC_BY_4;
    adc->smpr1 = ADC_SAMPLE_15;
    adc->smpr2 = ADC_SAMPLE_15;
    adc->cr2 = ADC_ON;
    start_pulses(timer);
    for (size_t i = 0; i < input_rows; i++) {
        gpio_analogue(inputs[i].port, inputs[i].pin);
    }
    for (size_t i = 0; i < output_rows; i++) {
        const int channel = pins_channel(outputs[i].port, outputs[i].pin);
        show(&outputs[i], outputs[i].safe);
        if (channel < DAC_CHANNELS) {
            gpio_analogue(outputs[i].port, outputs[i].pin);
            ((dac_registers *)DAC_AT)->cr |= channel == 0 ? DAC_1_ON : DAC_2_ON;
        } else {
            timer->ccer |= UINT32_C(1) << 4 * (channel - DAC_CHANNELS);
            gpio_alternate(outputs[i].port, outputs[i].pin, TIM3_FUNCTION);
        }
    }
    return NULL;
}

/* An input that is not measured keeps its last value. */
void iso_port_read(real *const u, const size_t count)
{
    for (size_t i = 0; i < input_rows; i++) {
        uint32_t value = 0;
        if (inputs[i].input < count &&
            adc_measure((adc_registers *)ADC1_AT, (uint32_t)adc_channel(inputs[i].port, inputs[i].pin), &value)) {
            u[inputs[i].input] = inputs[i].at_0 + (inputs[i].at_full - inputs[i].at_0) * ((real)value / R(4095.0));
        }
    }
}

void iso_port_publish(const real *const y, const size_t count)
{
    for (size_t i = 0; i < output_rows; i++) {
        if (outputs[i].output < count) {
            show(&outputs[i], (y[outputs[i].output] - outputs[i].at_0) / (outputs[i].at_full - outputs[i].at_0));
        }
    }
}

void iso_port_safe(void)
{
    for (size_t i = 0; i < output_rows; i++) {
        show(&outputs[i], outputs[i].safe);
    }
}
