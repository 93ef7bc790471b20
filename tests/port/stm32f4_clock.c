/* The clock tree of port/stm32f4, with registers that are memory: the arithmetic of the PLL within the limits of the
 * data sheets, and what becomes of each thing that does not answer. */
#include <string.h>

#include "tests/host/report.h"

#include "clock.h" /* these two as the test has them in its folder */
#include "port/stm32f4/usart.h"

static rcc_registers fake_rcc;
static pwr_registers fake_pwr;
static uint32_t fake_flash;
#undef RCC_AT
#define RCC_AT (&fake_rcc)
#undef PWR_AT
#define PWR_AT (&fake_pwr)
#undef FLASH_ACR_AT
#define FLASH_ACR_AT (&fake_flash)
#include "clock.c"

/* DS8626 and DS10693, main PLL characteristics and general operating conditions; RM0090 table 10, RM0390 table 5. */
static bool is_within_limits(const clock_tree *const t, const uint32_t source_hz, const bool is_f446)
{
    const uint32_t compared = source_hz / t->m;
    const uint64_t vco = (uint64_t)compared * t->n;
    return t->m >= 2 && t->m <= 63 && compared >= 950000 && compared <= 2100000 && source_hz % t->m == 0 &&
           t->n >= 50 && t->n <= 432 && vco >= 100000000 && vco <= 432000000 && t->p == 2 && vco / t->p == t->hz &&
           t->q >= 2 && t->q <= 15 && vco / t->q <= 48000000 && t->apb1_hz <= (is_f446 ? 45000000U : 42000000U) &&
           t->apb2_hz <= (is_f446 ? 90000000U : 84000000U);
}

static void test_limits(void)
{
    static const uint32_t sources[] = {8000000, 12000000, 16000000, 24000000, 26000000};
    for (unsigned i = 0; i < sizeof sources / sizeof sources[0]; i++) {
        const clock_tree f407 = clock_tree_of(sources[i], 168000000), f446 = clock_tree_of(sources[i], 180000000);
        report_ok(is_within_limits(&f407, sources[i], false) && is_within_limits(&f446, sources[i], true),
                  "a PLL from %u Hz", (unsigned)sources[i]);
    }
    clock_tree wrong = clock_tree_of(8000000, 168000000);
    wrong.n++;
    report_ok(!is_within_limits(&wrong, 8000000, false), "found: another factor");
    wrong = clock_tree_of(8000000, 180000000);
    report_ok(!is_within_limits(&wrong, 8000000, false), "found: a bus that is too fast for the F407");
    report_ok(clock_wait_states(30000000) == 0 && clock_wait_states(30000001) == 1 &&
                  clock_wait_states(150000000) == 4 && clock_wait_states(168000000) == 5 &&
                  clock_wait_states(180000000) == 5,
              "wait states by the table");
    const clock_tree t = clock_tree_of(8000000, 168000000);
    report_ok(clock_pllcfgr(&t, true) == 0x27402A04U, "the word of the PLL: 0x%08X", (unsigned)clock_pllcfgr(&t, true));
    const uint32_t buses[] = {HSI_HZ, 42000000, 45000000, 84000000, 90000000};
    for (unsigned i = 0; i < sizeof buses / sizeof buses[0]; i++) {
        const double rate = (double)buses[i] / usart_divider(buses[i]), error = rate / USART_BAUD - 1;
        report_ok(error > -0.015 && error < 0.015, "a line at %u Hz is off by %.2f %%", (unsigned)buses[i],
                  100 * error);
    }
}

/* What answers, and what comes of it. */
static void try(const char *const name, const uint32_t cr, const uint32_t csr, const uint32_t cfgr,
                const clock_source source, const uint32_t hz, const uint32_t m)
{
    memset(&fake_rcc, 0, sizeof fake_rcc);
    fake_rcc.cr = cr;
    fake_rcc.cfgr = cfgr;
    fake_pwr.csr = csr;
    fake_flash = 0;
    clock_start();
    const bool from_pll = source == CLOCK_PLL_HSI || source == CLOCK_PLL_HSE;
    report_ok(
        the_clock.source == source && the_clock.tree.hz == hz && (m == 0 || the_clock.tree.m == m) &&
            (!from_pll || ((fake_flash & 7) == 5 && (fake_rcc.cfgr & SWITCH) == TO_PLL && (fake_rcc.cr & PLL_ON) != 0)),
        "%s: %u Hz", name, (unsigned)the_clock.tree.hz);
}

int main(void)
{
    const uint32_t all = HSI_READY | HSE_READY | PLL_READY, od = OVERDRIVE_READY | OVERDRIVE_SWITCHED;
    const uint32_t switched = (uint32_t)TO_PLL << STATE_AT;
    test_limits();
    try("all answers", all, od, switched, CLOCK_PLL_HSE, FASTEST_HZ, 4);
    try("no crystal", all & ~(uint32_t)HSE_READY, od, switched, CLOCK_PLL_HSI, FASTEST_HZ, 8);
    try("no over-drive", all, 0, switched, CLOCK_PLL_HSE, PLAIN_HZ, 4);
    try("over-drive does not switch", all, OVERDRIVE_READY, switched, CLOCK_PLL_HSE, PLAIN_HZ, 4);
    try("the PLL does not lock", HSI_READY | HSE_READY, od, switched, CLOCK_HSI, HSI_HZ, 0);
    try("the switch stays", all, od, 0, CLOCK_HSI, HSI_HZ, 0);
    try("no RCC", 0, 0, 0, CLOCK_NONE, PLAIN_HZ, 0);
    return report_done();
}
