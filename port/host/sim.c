/* The host as a platform: a clock of nanoseconds that moves only when the loop waits, so that every run is the same.
 *
 *     PROGRAM [NANOSECONDS [SCRIPT]]
 *
 * A step needs no time, unless the script makes it slow.
 */
#include "port/host/script.h"

#include <stdio.h>
#include <stdlib.h>

#include "port/host/wires.h"
#include "port/pins/pins.h"
#include "port/port.h"
#include "port/unix/channel.h"
#include "port/unix/console.h"

static uint64_t now;      /* ns since the start */
static uint64_t period;   /* ns */
static uint64_t reported; /* the last tick that a wait returned */
static uint64_t step;     /* the present tick */
static uint32_t readings; /* of the clock, since the inputs of that tick were read */

uint32_t iso_port_start(const uint32_t period_ns)
{
    period = period_ns;
    now = 0;
    wires_period(period_ns);
    return period_ns;
}

uint64_t iso_port_wait(void)
{
    uint64_t tick = reported + 1;
    while (sim_script_has(SIM_LOSE, tick, NULL)) {
        tick++;
    }
    uint64_t delay = 0;
    (void)sim_script_has(SIM_LATE, tick, &delay);
    const uint64_t due = tick * period + delay;
    now = now < due ? due : now;
    reported = now / period;
    wires_latch(now);
    return reported;
}

/* The second reading after the inputs were read is the one that ends the step: a slow step shows there. */
uint64_t iso_port_clock(void)
{
    uint64_t delay = 0;
    readings++;
    if (readings == 2 && sim_script_has(SIM_SLOW, step, &delay)) {
        now += delay;
    }
    return now;
}

void iso_port_read(real *const u, const size_t inputs)
{
    step++;
    readings = 0;
    pins_read(u, inputs);
}

void iso_port_publish(const real *const y, const size_t outputs)
{
    pins_publish(y, outputs);
}

void iso_port_safe(void)
{
    pins_safe();
}

uint64_t iso_port_duration(const int argc, char **const argv)
{
    if (argc > 2) {
        sim_script_read(argv[2]);
    }
    const char *const error = pins_start();
    if (error != NULL) {
        fprintf(stderr, "the table of pins: %s\n", error);
        exit(EXIT_FAILURE);
    }
    return console_duration(argc, argv);
}

/* Virtual time waits for whatever comes in. */
int64_t host_until_tick(void)
{
    return -1;
}
