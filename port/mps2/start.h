/* What the start of a Cortex-M (start.c) asks of a platform. */
#ifndef ISO_PORT_MPS2_START_H
#define ISO_PORT_MPS2_START_H

/* Before main: turns on what the reset leaves off. Puts the words of the command line, at most so many, where they are told.
 * Returns their number; 0: there is no command line. */
int start_platform(char **words, int max);

#endif
