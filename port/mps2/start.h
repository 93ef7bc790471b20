/* The functions of a platform that the start of a Cortex-M (start.c) calls. */
#ifndef ISO_PORT_MPS2_START_H
#define ISO_PORT_MPS2_START_H

/* Before main: turns on the units that the reset leaves off. Puts the words of the command line, at most `max`, into
 * words[]. Returns their number; 0: there is no command line. */
int start_platform(char **words, int max);

#endif
