#include "port/mps2/semihosting.h"

#include <stdint.h>

enum { SYS_OPEN = 0x01, SYS_WRITE = 0x05, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };
enum { MODE_APPEND_BINARY = 9, APPLICATION_EXIT = 0x20026 };
#define OPEN_FAILED UINTPTR_MAX

#ifdef __riscv
/* Three instructions of 32 bits, of which the debugger knows the middle one by the others. */
static uintptr_t call(const uintptr_t operation, const uintptr_t *const arguments)
{
    register uintptr_t a0 __asm__("a0") = operation;
    register const uintptr_t *a1 __asm__("a1") = arguments;
    __asm__ volatile("    .option push\n"
                     "    .option norvc\n"
                     "    .balign 16\n"
                     "    slli zero, zero, 0x1F\n"
                     "    ebreak\n"
                     "    srai zero, zero, 7\n"
                     "    .option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
}
#else
static uintptr_t call(const uintptr_t operation, const uintptr_t *const arguments)
{
    register uintptr_t r0 __asm__("r0") = operation;
    register const uintptr_t *r1 __asm__("r1") = arguments;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}
#endif

/* The host's standard output as a file: a write to it waits for a slow reader, while the time of the board stands
 * still. QEMU's console would write a part and let time run on. Where the host has no such file, the console it is. */
static uintptr_t open_output(void)
{
    static const char output[] = "/dev/stdout";
    static const char console[] = ":tt";
    const uintptr_t file = call(SYS_OPEN, (uintptr_t[]){(uintptr_t)output, MODE_APPEND_BINARY, sizeof output - 1});
    return file != OPEN_FAILED
               ? file
               : call(SYS_OPEN, (uintptr_t[]){(uintptr_t)console, MODE_APPEND_BINARY, sizeof console - 1});
}

void semihosting_write(const void *const bytes, const size_t count)
{
    static uintptr_t output;
    if (output == 0) {
        output = open_output();
    }
    const uintptr_t left = call(SYS_WRITE, (uintptr_t[]){output, (uintptr_t)bytes, count});
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
