/* Standard output and arguments: those of a host, whatever its time is. */
#ifndef ISO_PORT_HOST_CONSOLE_H
#define ISO_PORT_HOST_CONSOLE_H

#include <stdint.h>

/* How long to run, in nanoseconds: the first argument; 0 without one. Ends the program with a message if it is no
 * number. */
uint64_t console_duration(int argc, char **argv);

#endif
