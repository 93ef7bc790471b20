/* The converter to voltages, 12 bits: PA4 and PA5. RM0090 14.5, RM0390 14.5. */
#ifndef ISO_PORT_STM32F4_DAC_H
#define ISO_PORT_STM32F4_DAC_H

#include <stdint.h>

typedef struct dac_registers {
    volatile uint32_t cr, swtrigr;
    struct {
        volatile uint32_t right_12, left_12, right_8;
    } channels[2];
} dac_registers;

#define DAC_AT UINT32_C(0x40007400)
enum { DAC_1_ON = 1 << 0, DAC_2_ON = 1 << 16, DAC_MOST = 4095 };

#endif
