#include "port/stm32f4/clock.h"

#include "port/stm32f4/board.h"

static rcc_registers *const rcc = (rcc_registers *)RCC_AT;
static pwr_registers *const pwr = (pwr_registers *)PWR_AT;
static volatile uint32_t *const flash_acr = (volatile uint32_t *)FLASH_ACR_AT;

clock_state the_clock;

/* Whether all these bits come within 200,000 looks: at 16 MHz more than 50 ms, where a crystal starts in 2 ms and the
 * PLL locks in 0.3 ms. */
static bool comes(const volatile uint32_t *const at, const uint32_t bits)
{
    for (uint32_t looks = 0; looks < 200000; looks++) {
        if ((*at & bits) == bits) {
            return true;
        }
    }
    return false;
}

/* Over-drive, which clocks above 168 MHz need: while the PLL runs, and before anything runs from it (RM0390, 5.1.4). */
static bool overdrive(void)
{
    pwr->cr |= OVERDRIVE_ON;
    if (!comes(&pwr->csr, OVERDRIVE_READY)) {
        return false;
    }
    pwr->cr |= OVERDRIVE_SWITCH;
    return comes(&pwr->csr, OVERDRIVE_SWITCHED);
}

static bool lock(const clock_tree *const tree, const bool from_hse)
{
    rcc->cr &= ~(uint32_t)PLL_ON;
    rcc->pllcfgr = clock_pllcfgr(tree, from_hse);
    rcc->cr |= PLL_ON;
    return comes(&rcc->cr, PLL_READY);
}

/* Wait states and dividers first: they are right for the slower clock too. */
static bool run_from_pll(const clock_tree *const tree)
{
    *flash_acr = tree->wait_states | PREFETCH | INSTRUCTION_CACHE | DATA_CACHE;
    if ((*flash_acr & 7) != tree->wait_states) {
        return false;
    }
    rcc->cfgr |= APB1_BY_4 | APB2_BY_2;
    rcc->cfgr = (rcc->cfgr & ~(uint32_t)SWITCH) | TO_PLL;
    return comes(&rcc->cfgr, (uint32_t)TO_PLL << STATE_AT);
}

void clock_start(void)
{
    if ((rcc->cr & HSI_READY) == 0) {
        the_clock = (clock_state){.tree = clock_tree_of(HSE_HZ, PLAIN_HZ), .source = CLOCK_NONE};
        return;
    }
    the_clock.source = CLOCK_HSI;
    the_clock.tree = (clock_tree){.hz = HSI_HZ, .apb1_hz = HSI_HZ, .apb2_hz = HSI_HZ};
    rcc->apb1enr |= PWR_CLOCK;
    rcc->cr |= HSE_IS_BYPASSED ? HSE_ON | HSE_BYPASS : HSE_ON;
    const bool from_hse = comes(&rcc->cr, HSE_READY);
    const uint32_t source_hz = from_hse ? HSE_HZ : HSI_HZ;
    clock_tree tree = clock_tree_of(source_hz, FASTEST_HZ);
    bool is_locked = lock(&tree, from_hse);
    if (is_locked && HAS_OVERDRIVE && !overdrive()) {
        pwr->cr &= ~(uint32_t)(OVERDRIVE_ON | OVERDRIVE_SWITCH);
        tree = clock_tree_of(source_hz, PLAIN_HZ);
        is_locked = lock(&tree, from_hse);
    }
    if (is_locked && run_from_pll(&tree)) {
        the_clock.tree = tree;
        the_clock.source = from_hse ? CLOCK_PLL_HSE : CLOCK_PLL_HSI;
    }
}
