/* The platform interface: nine functions. A port is one folder that defines them.
 *
 * The clock counts at the port's own rate; it reads 0 when iso_port_start returns, and tick k (k = 1, 2, ...) is due at
 * k times the period that iso_port_start gives. Clock and ticks have 64 bits and never wrap: a port whose counter has
 * fewer counts its overflows, in an interrupt that is never held off for longer than one takes.
 *
 * The floating-point unit is the port's duty, before main begins: where there is one it is on, rounds to nearest with
 * ties to even, and keeps numbers below the least normal one, both as operands and as results (no flush-to-zero, no
 * denormals-are-zero, no default NaN needed). No function of the port and no interrupt changes these modes, and an
 * interrupt that computes with reals saves the registers of the unit. iso_self_check (core/numbers/self_check.h) finds
 * a wrong mode by arithmetic, at the start of main.
 */
#ifndef ISO_PORT_PORT_H
#define ISO_PORT_PORT_H

#include <stddef.h>
#include <stdint.h>

#include "core/numbers/real.h"

#define iso_port_read ISO_REAL_NAME(iso_port_read)
#define iso_port_publish ISO_REAL_NAME(iso_port_publish)

/* Starts a tick every period_ns nanoseconds. Returns the period in counts of the clock. */
uint32_t iso_port_start(uint32_t period_ns);

/* Sleeps until a tick is due that the last call did not report. Returns the number of the latest due tick. */
uint64_t iso_port_wait(void);

/* The clock, in counts. */
uint64_t iso_port_clock(void);

/* Overwrites those of u[inputs] that the platform measures; the others keep the functions of the scene. */
void iso_port_read(real *u, size_t inputs);

/* Hands y[outputs] to the platform's digital-to-analogue converters, bus or network. */
void iso_port_publish(const real *y, size_t outputs);

/* Puts the platform's outputs into the state that does no harm: drives off, brakes on. The guard found a bad state; the
 * outputs published before were the last good ones. A platform that has no such state leaves them, and does nothing.
 * The next iso_port_publish ends it: a plant with a link goes on after a reset. */
void iso_port_safe(void);

/* Writes bytes to the console. */
void iso_port_write(const void *bytes, size_t count);

/* Returns how long to run, in nanoseconds of simulated time, from the arguments of main; 0 is until reset. */
uint64_t iso_port_duration(int argc, char **argv);

/* Ends the program: status 0 is success. */
_Noreturn void iso_port_exit(int status);

#endif
