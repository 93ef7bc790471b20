/* The differences of the boards: the chip's fastest clock, and the oscillator. */
#ifndef ISO_PORT_STM32F4_BOARD_H
#define ISO_PORT_STM32F4_BOARD_H

#include <stdint.h>

enum { HSI_HZ = 16000000 };

#ifdef BOARD_NUCLEO_F446RE
/* UM1724: the debugger of the Nucleo gives 8 MHz. Above 168 MHz the chip needs over-drive. */
enum { HSE_HZ = 8000000, HSE_IS_BYPASSED = 1, FASTEST_HZ = 180000000, HAS_OVERDRIVE = 1, PLAIN_HZ = 168000000 };
#else
/* UM1472: a crystal of 8 MHz on the Discovery with the F407; the F405 is the same chip without Ethernet and camera. */
enum { HSE_HZ = 8000000, HSE_IS_BYPASSED = 0, FASTEST_HZ = 168000000, HAS_OVERDRIVE = 0, PLAIN_HZ = 168000000 };
#endif

#endif
