/* The differences between the images of Arm's MPS2 and MPS3 boards that the ports run on.
 * Arm (2016), Application Note AN386; likewise AN385, AN500: 3.1 memory map, 3.7 interrupts. Arm (2020), Application
 * Note AN505: 3.1, 3.5; there the processor starts in the secure state, which sees the registers of the lines from
 * 0x50000000 on. So it does on the AN547, by the addresses and numbers of QEMU (hw/arm/mps2-tz.c). */
#ifndef ISO_PORT_MPS2_BOARD_H
#define ISO_PORT_MPS2_BOARD_H

#include <stdint.h>

#ifdef BOARD_AN505
#define BOARD_UART0 UINT32_C(0x50200000)
#define BOARD_UART1 UINT32_C(0x50201000)
/* The first interrupt of the lines. SysTick and lines at 20 MHz: 20.48 = 2^9 / 25 counts in 2^10 ns. */
enum { BOARD_FIRST_INTERRUPT = 32, BOARD_MHZ = 20, BOARD_DILATION_SHIFT = 9, BOARD_DILATION_OVER = 25 };
#elif defined BOARD_AN547
#define BOARD_UART0 UINT32_C(0x59303000)
#define BOARD_UART1 UINT32_C(0x59304000)
/* SysTick at 32 MHz: 32.768 = 2^12 / 125 counts. Lines at 25 MHz, and a cycle as on the other boards. */
enum { BOARD_FIRST_INTERRUPT = 33, BOARD_MHZ = 25, BOARD_DILATION_SHIFT = 12, BOARD_DILATION_OVER = 125 };
#else
#define BOARD_UART0 UINT32_C(0x40004000)
#define BOARD_UART1 UINT32_C(0x40005000)
/* At 25 MHz: 25.6 = 2^7 / 5 counts. */
enum { BOARD_FIRST_INTERRUPT = 0, BOARD_MHZ = 25, BOARD_DILATION_SHIFT = 7, BOARD_DILATION_OVER = 5 };
#endif

#endif
