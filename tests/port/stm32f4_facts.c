/* Addresses and bits that port/stm32f4 took from the reference manuals, against a second source: STMicroelectronics
 * (2023), cmsis_device_f4 2.6.10, stm32f405xx.h, stm32f407xx.h and stm32f446xx.h; Arm's core registers against CMSIS 5,
 * core_cm4.h. The numbers stand here as that source has them: address of a register, mask of a field. */
#include <stddef.h>

#include "port/stm32f4/adc.h"
#include "port/stm32f4/clock.h"
#include "port/stm32f4/dac.h"
#include "port/stm32f4/gpio.h"
#include "port/stm32f4/timer.h"
#include "port/stm32f4/usart.h"

#define AT(base, type, member, address) _Static_assert((base) + offsetof(type, member) == (address), #member)
#define BITS(name, mask) _Static_assert((uint32_t)(name) == (mask), #name)

AT(RCC_AT, rcc_registers, cr, 0x40023800U);
AT(RCC_AT, rcc_registers, pllcfgr, 0x40023804U);
AT(RCC_AT, rcc_registers, cfgr, 0x40023808U);
AT(RCC_AT, rcc_registers, ahb1enr, 0x40023830U);
AT(RCC_AT, rcc_registers, apb1enr, 0x40023840U);
AT(RCC_AT, rcc_registers, apb2enr, 0x40023844U);
AT(PWR_AT, pwr_registers, cr, 0x40007000U);
AT(PWR_AT, pwr_registers, csr, 0x40007004U);
BITS(FLASH_ACR_AT, 0x40023C00U);
BITS(HSI_READY, 0x00000002U);
BITS(HSE_ON, 0x00010000U);
BITS(HSE_READY, 0x00020000U);
BITS(HSE_BYPASS, 0x00040000U);
BITS(PLL_ON, 0x01000000U);
BITS(PLL_READY, 0x02000000U);
BITS(0x3F << PLL_M_AT, 0x0000003FU);
BITS(0x1FF << PLL_N_AT, 0x00007FC0U);
BITS(3 << PLL_P_AT, 0x00030000U);
BITS(PLL_FROM_HSE, 0x00400000U);
BITS(0xF << PLL_Q_AT, 0x0F000000U);
BITS(7 << PLL_R_AT, 0x70000000U);
BITS(SWITCH, 0x00000003U);
BITS(3 << STATE_AT, 0x0000000CU);
BITS(APB1_BY_4, 0x00001400U); /* PPRE1_2 and PPRE1_0 */
BITS(APB2_BY_2, 0x00008000U); /* PPRE2_2 */
BITS(TIM3_CLOCK, 0x00000002U);
BITS(USART2_CLOCK, 0x00020000U);
BITS(UART4_CLOCK, 0x00080000U);
BITS(PWR_CLOCK, 0x10000000U);
BITS(DAC_CLOCK, 0x20000000U);
BITS(USART6_CLOCK, 0x00000020U);
BITS(ADC1_CLOCK, 0x00000100U);
BITS(OVERDRIVE_ON, 0x00010000U);
BITS(OVERDRIVE_SWITCH, 0x00020000U);
BITS(OVERDRIVE_READY, 0x00010000U);
BITS(OVERDRIVE_SWITCHED, 0x00020000U);
BITS(PREFETCH, 0x00000100U);
BITS(INSTRUCTION_CACHE, 0x00000200U);
BITS(DATA_CACHE, 0x00000400U);

AT(GPIO_AT, gpio_registers, moder, 0x40020000U);
AT(GPIO_AT, gpio_registers, ospeedr, 0x40020008U);
AT(GPIO_AT, gpio_registers, pupdr, 0x4002000CU);
AT(GPIO_AT, gpio_registers, afr, 0x40020020U);
AT(GPIO_AT + 2 * GPIO_STRIDE, gpio_registers, moder, 0x40020800U); /* port C */

AT(USART2_AT, usart_registers, sr, 0x40004400U);
AT(USART2_AT, usart_registers, dr, 0x40004404U);
AT(USART2_AT, usart_registers, brr, 0x40004408U);
AT(USART2_AT, usart_registers, cr1, 0x4000440CU);
AT(UART4_AT, usart_registers, sr, 0x40004C00U);
AT(USART6_AT, usart_registers, sr, 0x40011400U);
BITS(USART2_INTERRUPT, 38U);
BITS(UART4_INTERRUPT, 52U);
BITS(USART6_INTERRUPT, 71U);
BITS(USART_RECEIVED, 0x00000020U);
BITS(USART_COMPLETE, 0x00000040U);
BITS(USART_EMPTY, 0x00000080U);
BITS(USART_RX_ON, 0x00000004U);
BITS(USART_TX_ON, 0x00000008U);
BITS(USART_RX_INTERRUPT, 0x00000020U);
BITS(USART_TX_INTERRUPT, 0x00000080U);
BITS(USART_ON, 0x00002000U);

AT(TIM3_AT, timer_registers, cr1, 0x40000400U);
AT(TIM3_AT, timer_registers, egr, 0x40000414U);
AT(TIM3_AT, timer_registers, ccmr, 0x40000418U);
AT(TIM3_AT, timer_registers, ccer, 0x40000420U);
AT(TIM3_AT, timer_registers, arr, 0x4000042CU);
AT(TIM3_AT, timer_registers, ccr, 0x40000434U);
BITS(TIMER_ON, 0x00000001U);
BITS(TIMER_RELOAD, 0x00000080U);
BITS(TIMER_TAKE_OVER, 0x00000001U);
BITS(CHANNEL_MODE_1, 0x00000060U); /* OC1M_2 and OC1M_1 */
BITS(CHANNEL_PRELOAD, 0x00000008U);

AT(ADC1_AT, adc_registers, sr, 0x40012000U);
AT(ADC1_AT, adc_registers, cr2, 0x40012008U);
AT(ADC1_AT, adc_registers, smpr1, 0x4001200CU);
AT(ADC1_AT, adc_registers, smpr2, 0x40012010U);
AT(ADC1_AT, adc_registers, sqr1, 0x4001202CU);
AT(ADC1_AT, adc_registers, sqr3, 0x40012034U);
AT(ADC1_AT, adc_registers, dr, 0x4001204CU);
BITS(ADC_CCR_AT, 0x40012304U);
BITS(ADC_DONE, 0x00000002U);
BITS(ADC_ON, 0x00000001U);
BITS(ADC_START, 0x40000000U);
BITS(ADC_BY_4, 0x00010000U); /* ADCPRE_0 */

AT(DAC_AT, dac_registers, cr, 0x40007400U);
AT(DAC_AT, dac_registers, channels[0].right_12, 0x40007408U);
AT(DAC_AT, dac_registers, channels[1].right_12, 0x40007414U);
BITS(DAC_1_ON, 0x00000001U);
BITS(DAC_2_ON, 0x00010000U);

AT(SYSTICK_AT, systick_registers, csr, 0xE000E010U);
AT(SYSTICK_AT, systick_registers, rvr, 0xE000E014U);
AT(SYSTICK_AT, systick_registers, cvr, 0xE000E018U);
BITS(ICSR_AT, 0xE000ED04U);
BITS(SYSTICK_PENDING, 0x04000000U);
