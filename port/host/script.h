/* What happens in a simulated run, from a text file: late, lost and slow ticks, and what stands at the pins:
 *
 *     # tick 5 is reported 300 us late, tick 7 is lost, and the step of tick 9 needs 1500 us
 *     late 5 300us
 *     lose 7
 *     slow 9 1500us
 *     # pin 3 is high from 1.25 ms to 2 ms; the voltage at pin 26 is converted to 2048 of 4095 from 3 ms on
 *     high 3 1250us
 *     low 3 2ms
 *     volts 26 3ms 2048
 *     # what the run shows at its pins goes to a file, in the same words
 *     record build/edges.txt
 */
#ifndef ISO_PORT_SIM_SCRIPT_H
#define ISO_PORT_SIM_SCRIPT_H

#include <stdbool.h>
#include <stdint.h>

typedef enum sim_kind { SIM_LATE, SIM_LOSE, SIM_SLOW } sim_kind;

/* Reads the script. On an error it ends the program with a message that names file and line. */
void sim_script_read(const char *path);

/* Whether the script does this to that tick; *ns is the duration it gives, if not NULL. */
bool sim_script_has(sim_kind kind, uint64_t tick, uint64_t *ns);

#endif
