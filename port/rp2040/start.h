/* From reset to main, and what the program was told. */
#ifndef ISO_PORT_RP2040_START_H
#define ISO_PORT_RP2040_START_H

#include <stdint.h>

/* The handlers of exceptions and, behind them, of interrupts, in RAM. */
enum { HANDLERS = 16 + 26 };
extern void (*the_handlers[HANDLERS])(void);

/* How long to run, in nanoseconds; 0 is until reset. */
uint64_t start_run_ns(void);

/* Whether this is the emulator: there the time of the board stands still while a plant waits for its controller. */
int start_is_emulated(void);

/* Unless it is NULL: writes what is wrong with the table of pins, and ends the program. */
void start_tell(const char *error);

/* The handler of the SysTick exception. */
void tick_interrupt(void);

#endif
