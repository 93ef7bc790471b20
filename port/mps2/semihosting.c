#include "port/mps2/semihosting.h"

#include <stdint.h>

enum { SYS_OPEN = 0x01, SYS_WRITE = 0x05, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };
enum { MODE_WRITE_BINARY = 5, APPLICATION_EXIT = 0x20026 };

static uintptr_t call(const uintptr_t operation, const uintptr_t *const arguments)
{
    register uintptr_t r0 __asm__("r0") = operation;
    register const uintptr_t *r1 __asm__("r1") = arguments;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void semihosting_write(const void *const bytes, const size_t count)
{
    static const char console_name[] = ":tt";
    static uintptr_t console;
    if (console == 0) {
        console = call(SYS_OPEN, (uintptr_t[]){(uintptr_t)console_name, MODE_WRITE_BINARY, sizeof console_name - 1});
    }
    const uintptr_t left = call(SYS_WRITE, (uintptr_t[]){console, (uintptr_t)bytes, count});
    if (left != 0) {
        semihosting_exit(1);
    }
}

int semihosting_arguments(char **const words, const int max)
{
    static char line[128];
    if (call(SYS_GET_CMDLINE, (uintptr_t[]){(uintptr_t)line, sizeof line}) != 0) {
        return 0;
    }
    int count = 0;
    char *at = line;
    while (*at != '\0' && count < max) {
        words[count++] = at;
        while (*at != '\0' && *at != ' ') {
            at++;
        }
        while (*at == ' ') {
            *at++ = '\0';
        }
    }
    return count;
}

_Noreturn void semihosting_exit(const int status)
{
    (void)call(SYS_EXIT_EXTENDED, (uintptr_t[]){APPLICATION_EXIT, (uintptr_t)status});
    for (;;) {
    }
}
