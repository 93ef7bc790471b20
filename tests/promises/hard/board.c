/* A hard case on the board: newlib's printf writes through semihosting, and what its main returns ends the program. */
#include <stddef.h>
#include <stdio.h>

#include "port/mps2/semihosting.h"

/* By the linker's --wrap=main, a reference to the one is to the other. */
int __wrap_main(int argc, char **argv);
int __real_main(int argc, char **argv);
int _write(int file, const char *bytes, int count);
void *_sbrk(ptrdiff_t more);

int _write(const int file, const char *const bytes, const int count)
{
    (void)file;
    semihosting_write(bytes, (size_t)count);
    return count;
}

/* What printf allocates: a buffer, and digits. */
void *_sbrk(const ptrdiff_t more)
{
    static max_align_t heap[1024];
    static size_t used;
    void *const at = (unsigned char *)heap + used;
    used += (size_t)more;
    return used <= sizeof heap ? at : (void *)-1;
}

int __wrap_main(const int argc, char **const argv)
{
    const int status = __real_main(argc, argv);
    return fflush(stdout) == 0 ? status : 1;
}
