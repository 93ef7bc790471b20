/* Late, lost and slow ticks of a simulated run, from a text file:
 *
 *     # tick 5 is reported 300 us late, tick 7 is lost, and the step of tick 9 needs 1500 us
 *     late 5 300us
 *     lose 7
 *     slow 9 1500us
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
