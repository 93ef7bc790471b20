/* From reset to main, and from a fault to the end of the program.
 * Arm (2021), Armv7-M Architecture Reference Manual, DDI 0403E.e: B1.5 exceptions, B3.2 system control.
 * Arm (2023), Armv8-M Architecture Reference Manual, DDI 0553B.w: stack limit checks, MSPLIM. */
#include <stdint.h>
#include <string.h>

#include "port/fault.h"
#include "port/mps2/start.h"
#include "port/mps2/tick.h"
#include "port/port.h"

#define CPACR (*(volatile uint32_t *)0xE000ED88U)
#define FPDSCR (*(volatile uint32_t *)0xE000EF3CU)
#define CFSR (*(const volatile uint32_t *)0xE000ED28U)

/* Full access to coprocessors 10 and 11, the FPU. */
#define CPACR_FPU_ON (UINT32_C(0xF) << 20)

/* The lanes of a loop in Armv8.1-M: 4 from reset, and else each end of a loop is a fault; 0 before. */
#define FPDSCR_LTPSIZE (UINT32_C(7) << 16)

/* From the linker script: places, and sizes as addresses. */
extern uint8_t data[], bss[], stack_top[];
extern const uint8_t stack_limit[];
extern const uint8_t data_image[], data_bytes[], bss_bytes[];

int main(int argc, char **argv);
_Noreturn void reset(void);
_Noreturn void fault(const uint32_t *frame);
void fault_entry(void);

/* Reports the fault, by the register CFSR, and its place. frame has the words that the exception pushed: r0-r3, r12,
 * lr, pc, xpsr; or is NULL, if the push may itself have been the fault. */
_Noreturn void fault(const uint32_t *const frame)
{
    fault_report(CFSR, frame != NULL ? &frame[6] : NULL);
}

/* Every unexpected exception comes here. A stack outside of the RAM, or at its limit, can neither be used nor read. */
__attribute__((naked)) void fault_entry(void)
{
    __asm__ volatile("    mov r0, sp\n"
                     "    ldr r1, =stack_limit\n"
                     "    cmp r0, r1\n"
                     "    bhi 0f\n"
                     "    movs r0, #0\n"
                     "0:  ldr r1, =stack_top\n"
                     "    mov sp, r1\n"
                     "    bl fault\n");
}

#if defined __ARM_ARCH_8M_MAIN__ || defined __ARM_ARCH_8_1M_MAIN__ /* which later compilers define for a Cortex-M55 */
/* A stack that grows out of the RAM faults at once: by a register. */
static void guard_stack(void)
{
    __asm__ volatile("msr msplim, %0" ::"r"(stack_limit));
}
#else
#define MPU_CTRL (*(volatile uint32_t *)0xE000ED94U)
#define MPU_RBAR (*(volatile uint32_t *)0xE000ED9CU)
#define MPU_RASR (*(volatile uint32_t *)0xE000EDA0U)

/* Region 0: the 2^28 bytes below the RAM, where nobody may read, write or execute; all else as without an MPU. */
#define MPU_BELOW_RAM (UINT32_C(0x10000000) | 1 << 4)
#define MPU_NO_ACCESS (UINT32_C(1) << 28 | (28 - 1) << 1 | 1)
#define MPU_ON (1 << 2 | 1)

/* A stack that grows out of the RAM faults at once. */
static void guard_stack(void)
{
    MPU_RBAR = MPU_BELOW_RAM;
    MPU_RASR = MPU_NO_ACCESS;
    MPU_CTRL = MPU_ON;
    __asm__ volatile("dsb\n    isb" ::: "memory");
}
#endif

/* Nothing before the first line may use a floating-point register, where the chip has them. */
_Noreturn void reset(void)
{
#ifdef __ARM_FP
    CPACR |= CPACR_FPU_ON;
    __asm__ volatile("dsb\n    isb" ::: "memory");

    /* Round to nearest, keep denormals, keep NaN payloads: here, and in interrupts that use the FPU. */
    const uint32_t mode = FPDSCR & FPDSCR_LTPSIZE;
    FPDSCR = mode;
    __asm__ volatile("vmsr fpscr, %0" ::"r"(mode) : "memory");
#endif

    guard_stack();

    memcpy(data, data_image, (size_t)data_bytes);
    memset(bss, 0, (size_t)bss_bytes);

    enum { ARGUMENTS_MAX = 4 };
    char *arguments[ARGUMENTS_MAX + 1] = {NULL};
    iso_port_exit(main(start_platform(arguments, ARGUMENTS_MAX), arguments));
}

typedef union vector {
    void *stack;
    void (*handler)(void);
} vector;

/* By number of the exception; the first entry is the stack. Nothing else is enabled: other faults become hard ones. */
enum { NON_MASKABLE = 2, HARD_FAULT = 3, SYSTICK = 15 };

__attribute__((section(".vectors"), used)) const vector vectors[] = {
    {.stack = stack_top},
    {.handler = reset},
    [NON_MASKABLE] = {.handler = fault_entry},
    [HARD_FAULT] = {.handler = fault_entry},
    [SYSTICK] = {.handler = tick_interrupt},
};
