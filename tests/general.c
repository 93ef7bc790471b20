/* No count of a loop is known here: to unroll would be most of what this file takes to compile. */
#define ISO_UNROLL

#include "tests/general.h"

__attribute__((cold)) void general_prime(const unsigned recipe, const size_t n, const iso_equations *const eq,
                                         const real h, real *const x, const real *const u, const real *const p,
                                         real *const lu, real *const work, iso_progress *const progress)
{
    iso_method_prime(recipe, n, eq, h, x, u, p, lu, work, progress);
}

void general_step(const unsigned recipe, const size_t n, const iso_equations *const eq, const real h, real *const x,
                  const real *const u, const real *const p, real *const lu, real *const work,
                  iso_progress *const progress)
{
    iso_method_step(recipe, n, eq, h, x, u, p, lu, work, progress);
}
