/* Adams-Bashforth-Moulton of order four in the mode P(EC)^2 E: corrects twice. Three evaluations. */
#ifndef ISO_CORE_METHODS_ABM4_PECECE_H
#define ISO_CORE_METHODS_ABM4_PECECE_H

#include "core/methods/abm4.h"

ISO_INLINE void iso_abm4_pecece_step(iso_step *const step)
{
    iso_abm4_correct(step, 2, true);
}

/* The columns of core/methods/table.h. */
#define ISO_ABM4_PECECE_ORDER(r) 4
#define ISO_ABM4_PECECE_STAGES(r) 0
#define ISO_ABM4_PECECE_TABLEAU NULL
#define ISO_ABM4_PECECE_EVALUATIONS(r) 3
#define ISO_ABM4_PECECE_SOLUTIONS(r) 0
#define ISO_ABM4_PECECE_PAST(r) (ISO_ABM4_SUMS + ISO_IS_LATE(r))
#define ISO_ABM4_PECECE_WORK(r) 2
#define ISO_ABM4_PECECE_PRIME(r) ISO_PRIME_VECTORS
#define ISO_ABM4_PECECE_PRIMES(r) iso_abm4_prime
#define ISO_ABM4_PECECE_SUMS(r) (9 + ISO_IS_CHECKED(r) + ISO_IS_LATE(r))
#define ISO_ABM4_PECECE_PRODUCTS(r) (9 + 2 * ISO_IS_LATE(r))
#define ISO_ABM4_PECECE_KIND(r) ISO_CORRECTING

#endif
