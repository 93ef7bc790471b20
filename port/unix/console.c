#include "port/unix/console.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "port/port.h"

void iso_port_write(const void *const bytes, const size_t count)
{
    if (fwrite(bytes, 1, count, stdout) != count) {
        perror("standard output");
        exit(EXIT_FAILURE);
    }
}

_Noreturn void iso_port_exit(const int status)
{
    if (fflush(stdout) != 0) {
        perror("standard output");
        exit(EXIT_FAILURE);
    }
    exit(status);
}

uint64_t console_duration(const int argc, char **const argv)
{
    if (argc < 2) {
        return 0;
    }
    char *end = NULL;
    errno = 0;
    const uint64_t duration = strtoull(argv[1], &end, 10);
    if (argv[1][0] < '0' || argv[1][0] > '9' || *end != '\0' || errno != 0) {
        fprintf(stderr, "%s: expected a duration in nanoseconds, not '%s'\n", argv[0], argv[1]);
        exit(EXIT_FAILURE);
    }
    return duration;
}
