/* Euler's method: x += h f. */
#ifndef ISO_CORE_METHODS_EULER_H
#define ISO_CORE_METHODS_EULER_H

#include "core/methods/explicit.h"

/* Euler (1768), Institutionum calculi integralis, vol. 1, sec. 2, ch. 7. */
static const iso_tableau iso_tableau_euler = {
    .stages = 1,
    .order = 1,
    .a_over = {1},
    .b = {1},
    .b_over = 1,
};

ISO_INLINE void iso_euler_step(iso_step *const step)
{
    iso_explicit_method(&iso_tableau_euler, step);
}

/* The columns of core/methods/table.h. */
#define ISO_EULER_ORDER(r) 1
#define ISO_EULER_STAGES(r) 1
#define ISO_EULER_TABLEAU &iso_tableau_euler
#define ISO_EULER_EVALUATIONS(r) 1
#define ISO_EULER_SOLUTIONS(r) 0
#define ISO_EULER_PAST(r) 0
#define ISO_EULER_WORK(r) 2
#define ISO_EULER_PRIME(r) ISO_PRIME_VECTORS
#define ISO_EULER_PRIMES(r) iso_prime_check
#define ISO_EULER_SUMS(r) 0
#define ISO_EULER_PRODUCTS(r) 1
#define ISO_EULER_KIND(r) ISO_FROM_START

#endif
