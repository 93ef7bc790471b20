/* Adams-Bashforth-Moulton of order four in the mode PEC: predict, evaluate, correct. One evaluation. */
#ifndef ISO_CORE_METHODS_ABM4_PEC_H
#define ISO_CORE_METHODS_ABM4_PEC_H

#include "core/methods/abm4.h"

ISO_INLINE void iso_abm4_pec_step(iso_step *const step)
{
    iso_abm4_correct(step, 1, false);
}

static inline void iso_abm4_pec_prime(iso_step *const step)
{
    iso_abm4_fill(step, false);
}

/* The columns of core/methods/table.h. */
#define ISO_ABM4_PEC_ORDER(r) 4
#define ISO_ABM4_PEC_STAGES(r) 0
#define ISO_ABM4_PEC_TABLEAU NULL
#define ISO_ABM4_PEC_EVALUATIONS(r) 1
#define ISO_ABM4_PEC_SOLUTIONS(r) 0
#define ISO_ABM4_PEC_PAST(r) ISO_ABM4_SUMS
#define ISO_ABM4_PEC_WORK(r) 2
#define ISO_ABM4_PEC_PRIME(r) ISO_PRIME_VECTORS
#define ISO_ABM4_PEC_PRIMES(r) iso_abm4_pec_prime
#define ISO_ABM4_PEC_SUMS(r) (7 + ISO_IS_CHECKED(r))
#define ISO_ABM4_PEC_PRODUCTS(r) 8
#define ISO_ABM4_PEC_KIND(r) ISO_PREDICTING

#endif
