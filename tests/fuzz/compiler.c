/* A text as a scene, through the whole of isoc: whatever it says, isoc ends, and gives all memory back. */
#define _GNU_SOURCE
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* That of tools/isoc/main.c. */
int isoc_main(int count, char **arguments);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *const bytes, const size_t count)
{
    const int file = memfd_create("scene", 0);
    char path[32];
    if (file < 0 || write(file, bytes, count) != (ssize_t)count) {
        abort();
    }
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    char *arguments[] = {"isoc", path, "-o", getenv("FUZZ_OUT"), NULL};
    (void)isoc_main(4, arguments);
    close(file);
    return 0;
}
