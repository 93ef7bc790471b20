/* From reset to main, and from a fault to the end of the program.
 * RISC-V (2021), The RISC-V Instruction Set Manual, Volume II: Privileged Architecture, version 20211203: 3.1. */
#include <stdint.h>
#include <string.h>

#include "port/fault.h"
#include "port/mps2/start.h"
#include "port/port.h"
#include "port/virt/tick.h"

/* From the linker script: a place, and a size as an address. */
extern uint8_t bss[];
extern const uint8_t bss_bytes[];

int main(int argc, char **argv);
void entry(void);
void trap_entry(void);
void timer_entry(void);
_Noreturn void reset(void);
_Noreturn void fault(uint32_t cause, uint32_t place);

/* Reports the fault, by the register mcause, and its place. */
_Noreturn void fault(const uint32_t cause, const uint32_t place)
{
    fault_report(cause, &place);
}

/* The timer's is the only interrupt that is enabled. It keeps the registers that it uses; those of floating point it
 * does not use. */
__attribute__((interrupt)) void timer_entry(void)
{
    tick_interrupt();
}

/* An interrupt has the sign bit of the cause set. A stack outside of the RAM cannot be used: a fault has it anew. */
__attribute__((naked, aligned(4))) void trap_entry(void)
{
    __asm__ volatile("    csrw mscratch, t0\n"
                     "    csrr t0, mcause\n"
                     "    bgez t0, 0f\n"
                     "    csrr t0, mscratch\n"
                     "    j timer_entry\n"
                     "0:  la sp, stack_top\n"
                     "    csrr a0, mcause\n"
                     "    csrr a1, mepc\n"
                     "    call fault\n");
}

/* The first instruction. */
__attribute__((naked, section(".entry"))) void entry(void)
{
    __asm__ volatile("    la sp, stack_top\n"
                     "    la t0, trap_entry\n"
                     "    csrw mtvec, t0\n"
                     "    tail reset\n");
}

/* Nothing before the first line may use a floating-point register, where the chip has them: they are turned on, with
 * rounding to nearest. */
_Noreturn void reset(void)
{
#ifdef __riscv_flen
    __asm__ volatile("csrs mstatus, %0\n    csrw fcsr, zero" ::"r"(1 << 13) : "memory");
#endif
    memset(bss, 0, (size_t)bss_bytes);

    enum { ARGUMENTS_MAX = 4 };
    char *arguments[ARGUMENTS_MAX + 1] = {NULL};
    iso_port_exit(main(start_platform(arguments, ARGUMENTS_MAX), arguments));
}
