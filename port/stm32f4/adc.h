/* The converter of measured voltages, 12 bits. RM0090 13.13, RM0390 13.13. */
#ifndef ISO_PORT_STM32F4_ADC_H
#define ISO_PORT_STM32F4_ADC_H

#include <stdbool.h>
#include <stdint.h>

typedef struct adc_registers {
    volatile uint32_t sr, cr1, cr2, smpr1, smpr2, jofr[4], htr, ltr, sqr1, sqr2, sqr3, jsqr, jdr[4], dr;
} adc_registers;

#define ADC1_AT UINT32_C(0x40012000)
#define ADC_CCR_AT UINT32_C(0x40012304)
enum { ADC_DONE = 1 << 1, ADC_ON = 1 << 0, ADC_START = 1 << 30, ADC_BY_4 = 1 << 16, ADC_FULL = 4096 };

/* 15 cycles for the sample of each channel, with 12 for its bits: at 21 MHz 1.3 us, at 22.5 MHz 1.2 us. */
#define ADC_SAMPLE_15 UINT32_C(0x09249249)

/* The channel of a pin (data sheets, pin definitions: ADC123_INx); -1: it has none. */
static inline int adc_channel(const char port, const unsigned pin)
{
    return port == 'A' && pin < 8   ? (int)pin
           : port == 'B' && pin < 2 ? 8 + (int)pin
           : port == 'C' && pin < 6 ? 10 + (int)pin
                                    : -1;
}

/* Measures a channel in a bounded time. Returns whether there is a value. */
static inline bool adc_measure(adc_registers *const adc, const uint32_t channel, uint32_t *const value)
{
    adc->sqr3 = channel;
    adc->cr2 |= ADC_START;
    for (unsigned looks = 0; looks < 1000; looks++) {
        if ((adc->sr & ADC_DONE) != 0) {
            *value = adc->dr;
            return true;
        }
    }
    return false;
}

#endif
