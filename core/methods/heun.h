/* Heun's method: the trapezoidal rule with an Euler predictor. */
#ifndef ISO_CORE_METHODS_HEUN_H
#define ISO_CORE_METHODS_HEUN_H

#include "core/methods/explicit.h"

/* Heun (1900), Z. Math. Phys. 45, 23-38. */
static const iso_tableau iso_tableau_heun = {
    .stages = 2,
    .order = 2,
    .a = {{0}, {1}},
    .a_over = {1, 1},
    .b = {1, 1},
    .b_over = 2,
};

ISO_INLINE void iso_heun_step(iso_step *const step)
{
    iso_explicit_method(&iso_tableau_heun, step);
}

/* The columns of core/methods/table.h. */
#define ISO_HEUN_ORDER(r) 2
#define ISO_HEUN_STAGES(r) 2
#define ISO_HEUN_TABLEAU &iso_tableau_heun
#define ISO_HEUN_EVALUATIONS(r) 2
#define ISO_HEUN_SOLUTIONS(r) 0
#define ISO_HEUN_PAST(r) 0
#define ISO_HEUN_WORK(r) 3
#define ISO_HEUN_PRIME(r) ISO_PRIME_VECTORS
#define ISO_HEUN_PRIMES(r) iso_prime_check
#define ISO_HEUN_SUMS(r) 2
#define ISO_HEUN_PRODUCTS(r) 2
#define ISO_HEUN_KIND(r) ISO_FROM_START

#endif
