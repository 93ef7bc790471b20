/* What goes wrong in a simulated run, read from a text file:
 *
 *     # tick 5 is reported 300 us after it was due, tick 7 never, and the step of tick 9 takes 1500 us
 *     late 5 300us
 *     lose 7
 *     slow 9 1500us
 */
#ifndef ISO_PORT_SIM_SCRIPT_H
#define ISO_PORT_SIM_SCRIPT_H

#include <stdbool.h>
#include <stdint.h>

typedef enum sim_kind { SIM_LATE, SIM_LOSE, SIM_SLOW } sim_kind;

/* Reads the script. Ends the program with a message that names file and line if something is wrong with it. */
void sim_script_read(const char *path);

/* Whether the script does this to that tick; *ns is the duration it gives, if not NULL. */
bool sim_script_has(sim_kind kind, uint32_t tick, uint64_t *ns);

#endif
