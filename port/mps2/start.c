/* From reset to main, and from a fault to the end of the program.
 * Arm (2021), Armv7-M Architecture Reference Manual, DDI 0403E.e: B1.5 exceptions, B3.2 system control. */
#include <stdint.h>

#include "port/mps2/semihosting.h"
#include "port/mps2/tick.h"
#include "port/port.h"

#define CPACR (*(volatile uint32_t *)0xE000ED88U)
#define FPDSCR (*(volatile uint32_t *)0xE000EF3CU)
#define CFSR (*(const volatile uint32_t *)0xE000ED28U)

/* Full access to coprocessors 10 and 11, the FPU. */
#define CPACR_FPU_ON (UINT32_C(0xF) << 20)

extern uint64_t data_begin[], data_end[], bss_begin[], bss_end[];
extern const uint64_t data_image[];
extern uint32_t stack_top[];

int main(int argc, char **argv);
_Noreturn void reset(void);
_Noreturn void fault(const uint32_t *frame);
void fault_entry(void);

static void put_word(const char *const name, const uint32_t word)
{
    char digits[8];
    size_t length = 0;
    while (name[length] != '\0') {
        length++;
    }
    for (unsigned i = 0; i < sizeof digits; i++) {
        digits[i] = "0123456789abcdef"[word >> (28 - 4 * i) & 0xF];
    }
    semihosting_write(name, length);
    semihosting_write(digits, sizeof digits);
}

/* frame is what the exception pushed, or NULL if that may itself have been the fault: r0-r3, r12, lr, pc, xpsr. */
_Noreturn void fault(const uint32_t *const frame)
{
    put_word("Bail out! fault ", CFSR);
    if (frame != NULL) {
        put_word(" at 0x", frame[6]);
    }
    semihosting_write("\n", 1);
    semihosting_exit(1);
}

/* Every unexpected exception comes here. A stack that has left the RAM is no place to run on, nor to read from. */
__attribute__((naked)) void fault_entry(void)
{
    __asm__ volatile("    mov r0, sp\n"
                     "    ldr r1, =stack_limit\n"
                     "    cmp r0, r1\n"
                     "    it lo\n"
                     "    movlo r0, #0\n"
                     "    ldr r1, =stack_top\n"
                     "    mov sp, r1\n"
                     "    b fault\n");
}

/* Nothing before the first line may use a floating-point register. */
_Noreturn void reset(void)
{
    CPACR |= CPACR_FPU_ON;
    __asm__ volatile("dsb\n    isb" ::: "memory");

    /* Round to nearest, keep denormals, keep NaN payloads: here, and in interrupts that use the FPU. */
    FPDSCR = 0;
    __asm__ volatile("vmsr fpscr, %0" ::"r"(0) : "memory");

    for (const uint64_t *from = data_image, *to = data_begin; to < data_end;) {
        *(uint64_t *)(uintptr_t)to++ = *from++;
    }
    for (uint64_t *to = bss_begin; to < bss_end;) {
        *to++ = 0;
    }

    enum { ARGUMENTS_MAX = 4 };
    char *arguments[ARGUMENTS_MAX + 1] = {NULL};
    iso_port_exit(main(semihosting_arguments(arguments, ARGUMENTS_MAX), arguments));
}

typedef union vector {
    void *stack;
    void (*handler)(void);
} vector;

__attribute__((section(".vectors"), used)) const vector vectors[] = {
    {.stack = stack_top},
    {.handler = reset},
    {.handler = fault_entry}, /* non-maskable interrupt */
    {.handler = fault_entry}, /* hard fault, and those below as long as they are not enabled */
    {.handler = fault_entry}, /* memory management */
    {.handler = fault_entry}, /* bus */
    {.handler = fault_entry}, /* usage */
    {.handler = fault_entry},
    {.handler = fault_entry},
    {.handler = fault_entry},
    {.handler = fault_entry},
    {.handler = fault_entry}, /* supervisor call */
    {.handler = fault_entry}, /* debug monitor */
    {.handler = fault_entry},
    {.handler = fault_entry}, /* pending supervisor call */
    {.handler = tick_interrupt},
};
