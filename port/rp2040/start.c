/* From the second stage to main: the program copies itself into RAM, starts the clocks, and calls main.
 *
 * RP2040 Datasheet: 2.15 clocks, 2.16 XOSC, 2.18 PLL. Nothing here gives up on the crystal or the PLL: the boot ROM
 * needs both too, to be a drive on USB. */
#include "port/rp2040/start.h"

#include "port/fault.h"
#include "port/rp2040/registers.h"

/* From the linker script. */
extern uint32_t data[], bss[], stack_top[];
extern const uint32_t data_image[], stack_limit[];
extern const uint8_t data_bytes[], bss_bytes[]; /* sizes as addresses */
extern const volatile uint32_t told_run_ns[2], told_emulated;

int main(int argc, char **argv);
_Noreturn void reset(void);
_Noreturn void fault(const uint32_t *frame);
void fault_entry(void);

uint64_t start_run_ns(void)
{
    return (uint64_t)told_run_ns[1] << 32 | told_run_ns[0];
}

int start_is_emulated(void)
{
    return told_emulated != 0;
}

/* Armv6-M has one fault and no register that says why. frame has the words that it pushed: r0-r3, r12, lr, pc, xpsr; or
 * is NULL, if the push may itself have been the fault. */
_Noreturn void fault(const uint32_t *const frame)
{
    enum { HARD_FAULT = 3 };
    fault_report(HARD_FAULT, frame != NULL ? &frame[6] : NULL);
}

/* Every unexpected exception comes here. A stack outside of the RAM can neither be used nor read. */
__attribute__((naked)) void fault_entry(void)
{
    __asm__ volatile("    mov r0, sp\n"
                     "    ldr r1, =stack_limit\n"
                     "    cmp r0, r1\n"
                     "    bhi 0f\n"
                     "    movs r0, #0\n"
                     "0:  ldr r1, =stack_top\n"
                     "    mov sp, r1\n"
                     "    bl fault\n"
                     "    .pool\n");
}

void (*the_handlers[HANDLERS])(void)
    __attribute__((aligned(256))) = {[2] = fault_entry, [3] = fault_entry, [15] = tick_interrupt};

/* The crystal, then the reference clock and that of the system; the PLL for USB makes the 48 MHz of the ADC. */
static void start_pll(const registers pll, const uint32_t unit, const uint32_t factor, const uint32_t first,
                      const uint32_t second)
{
    units_start(unit);
    pll[PLL_CS] = 1; /* the reference, by 1 */
    pll[PLL_FACTOR] = factor;
    pll[CLEARS + PLL_POWER] = PLL_OFF | PLL_VCO_OFF;
    while ((pll[PLL_CS] & IS_STABLE) == 0) {
    }
    pll[PLL_DIVIDERS] = first << DIVIDER_1_AT | second << DIVIDER_2_AT;
    pll[CLEARS + PLL_POWER] = PLL_DIVIDERS_OFF;
}

static void start_clocks(void)
{
    XOSC[XOSC_CTRL] = XOSC_1_TO_15_MHZ;
    XOSC[XOSC_STARTUP] = (CRYSTAL_START_US * CRYSTAL_MHZ + 255) / 256;
    XOSC[SETS + XOSC_CTRL] = XOSC_ENABLE;
    while ((XOSC[XOSC_STATUS] & IS_STABLE) == 0) {
    }
    CLOCKS[CLK_REF_CTRL] = FROM_CRYSTAL;
    while ((CLOCKS[CLK_REF_SELECTED] & 1 << FROM_CRYSTAL) == 0) {
    }
    CLOCKS[CLK_SYS_CTRL] = FROM_REFERENCE; /* also where a debugger reset the core alone, which ran from the PLL */
    while ((CLOCKS[CLK_SYS_SELECTED] & 1 << FROM_REFERENCE) == 0) {
    }
    start_pll(PLL_SYS, UNIT_PLL_SYS, VCO_MHZ / CRYSTAL_MHZ, 6, 2);
    start_pll(PLL_USB, UNIT_PLL_USB, 100, 5, 5);
    CLOCKS[CLK_SYS_CTRL] = FROM_PLL; /* that of the system: the source 0 behind the switch */
    while ((CLOCKS[CLK_SYS_SELECTED] & 1 << FROM_PLL) == 0) {
    }
    CLOCKS[CLK_PERI_CTRL] = CLK_ON;
    CLOCKS[CLK_ADC_CTRL] = CLK_ON;
}

static void begin(void)
{
    start_clocks();
    iso_port_exit(main(0, NULL));
}

/* In flash, where nothing of the rest can be called yet. Words by volatile pointers: the compiler would make memcpy of
 * it. */
__attribute__((section(".start"))) _Noreturn void reset(void)
{
    volatile uint32_t *const words = data, *const zeros = bss;
    const volatile uint32_t *const image = data_image;
    for (uintptr_t i = 0; i < (uintptr_t)data_bytes / sizeof words[0]; i++) {
        words[i] = image[i];
    }
    for (uintptr_t i = 0; i < (uintptr_t)bss_bytes / sizeof zeros[0]; i++) {
        zeros[i] = 0;
    }
    VTOR = (uintptr_t)the_handlers;
    void (*volatile const run)(void) = begin; /* by its address: a branch from flash to RAM is too far */
    run();
    for (;;) {
    }
}

typedef union vector {
    void *stack;
    void (*handler)(void);
} vector;

__attribute__((section(".vectors"), used)) const vector vectors[] = {{.stack = stack_top}, {.handler = reset}};
