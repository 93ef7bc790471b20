/* A step of a method, and its priming, where the recipe and the number of states are known only when they run: all
 * kernels, in a file of their own, which the tests compile once. The arguments are those of iso_method_step and
 * iso_method_prime. */
#ifndef ISO_TESTS_GENERAL_H
#define ISO_TESTS_GENERAL_H

#include "core/methods/all.h"
#include "core/methods/primed.h"

void general_prime(unsigned recipe, size_t n, const iso_equations *eq, real h, real *x, const real *u, const real *p,
                   real *lu, real *work, iso_progress *progress);

void general_step(unsigned recipe, size_t n, const iso_equations *eq, real h, real *x, const real *u, const real *p,
                  real *lu, real *work, iso_progress *progress);

#endif
