/* The console, the arguments and the end of a program that a debugger, or QEMU, serves by semihosting.
 *
 *     arguments: PROGRAM [NANOSECONDS] */
#include "port/mps2/semihosting.h"
#include "port/mps2/start.h"
#include "port/port.h"

int start_platform(char **const words, const int max)
{
    return semihosting_arguments(words, max);
}

void iso_port_write(const void *const bytes, const size_t count)
{
    semihosting_write(bytes, count);
}

__attribute__((cold)) uint64_t iso_port_duration(const int argc, char **const argv)
{
    uint64_t duration = 0;
    if (argc > 1) {
        for (const char *digit = argv[1]; *digit >= '0' && *digit <= '9'; digit++) {
            duration = duration * 10 + (uint64_t)(*digit - '0');
        }
    }
    return duration;
}

_Noreturn void iso_port_exit(const int status)
{
    semihosting_exit(status);
}
