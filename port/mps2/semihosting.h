/* Arm semihosting: the debugger, or QEMU, as console, command line and exit.
 * Arm (2023), Semihosting for AArch32 and AArch64, version 2023Q3. RISC-V (2023), RISC-V Semihosting, version 0.3. */
#ifndef ISO_PORT_MPS2_SEMIHOSTING_H
#define ISO_PORT_MPS2_SEMIHOSTING_H

#include <stddef.h>

/* Writes bytes to the console. */
void semihosting_write(const void *bytes, size_t count);

/* Splits the command line at its spaces into at most max words, which stay where they are. Returns their number. */
int semihosting_arguments(char **words, int max);

/* Ends the program with a status. */
_Noreturn void semihosting_exit(int status);

#endif
