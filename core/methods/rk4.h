/* The classical Runge-Kutta method of order four. */
#ifndef ISO_CORE_METHODS_RK4_H
#define ISO_CORE_METHODS_RK4_H

#include "core/methods/explicit.h"

/* Kutta (1901), Z. Math. Phys. 46, 435-453. */
static const iso_tableau iso_tableau_rk4 = {
    .stages = 4,
    .order = 4,
    .a = {{0}, {1}, {0, 1}, {0, 0, 1}},
    .a_over = {1, 2, 2, 1},
    .b = {1, 2, 2, 1},
    .b_over = 6,
};

/* Vectors of work space: the derivatives of all stages, and the state of one. */
enum { ISO_RK4_VECTORS = 5 };

ISO_INLINE void iso_rk4_step(iso_step *const step)
{
    iso_explicit_method(&iso_tableau_rk4, step);
}

/* The columns of core/methods/table.h. */
#define ISO_RK4_ORDER(r) 4
#define ISO_RK4_STAGES(r) 4
#define ISO_RK4_TABLEAU &iso_tableau_rk4
#define ISO_RK4_EVALUATIONS(r) 4
#define ISO_RK4_SOLUTIONS(r) 0
#define ISO_RK4_PAST(r) 0
#define ISO_RK4_WORK(r) ISO_RK4_VECTORS
#define ISO_RK4_PRIME(r) ISO_PRIME_VECTORS
#define ISO_RK4_PRIMES(r) iso_prime_check
#define ISO_RK4_SUMS(r) 6
#define ISO_RK4_PRODUCTS(r) 5
#define ISO_RK4_KIND(r) ISO_FROM_START

#endif
