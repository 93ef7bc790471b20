/* The error of core/numbers/root.h, on the host.
 *
 * usage: root [STRIDE]. In float every STRIDE-th number of [1, 4) against double; in double 4e6 / STRIDE random ones
 * against long double. A factor of 4 in the argument halves the result exactly, which is tried over the whole domain of
 * float.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/numbers/root.h"

#ifdef ISO_REAL_DOUBLE
typedef long double wide;
enum { NUMBERS = 4000000 };
#else
typedef double wide;
enum { NUMBERS = 1 << 24 };
#endif

static const double bound = 1.5; /* ulp */

/* Number i of [1, 4): in float all of them; in double splitmix64 (Vigna 2015). */
static real number(const uint64_t i)
{
#ifdef ISO_REAL_DOUBLE
    uint64_t z = (i + 1) * UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return 1.0 + 3.0 * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
#else
    return iso_real_of(iso_bits_of(1.0f) + (iso_bits)i);
#endif
}

int main(const int argc, char **const argv)
{
    const uint64_t stride = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    if (stride == 0) {
        fprintf(stderr, "usage: %s [STRIDE]\n", argv[0]);
        return 2;
    }
    double worst = 0.0;
    bool scales = true;
    for (uint64_t i = 0; i < NUMBERS; i += stride) {
        const real x = number(i), got = iso_inverse_root(x);
        const wide want = (wide)(1 / sqrtl((long double)x));
        const double ulp = (double)(want >= 1 ? ISO_REAL_EPSILON : ISO_REAL_EPSILON / 2);
        const double error = fabs((double)((wide)got - want)) / ulp;
        worst = error <= worst ? worst : error;
        const int k = (int)(i / stride % 114) - 50; /* from 2^-100 on: the domain begins at 2^-101 */
        scales = scales && iso_inverse_root(x * (real)ldexp(1.0, 2 * k)) == got * (real)ldexp(1.0, -k);
    }
    const real none = iso_inverse_root(R(0.0)), least = iso_inverse_root(iso_real_of(1));
    const bool finite = R(0.0) * none == R(0.0) && R(0.0) * least == R(0.0) && none > R(1e18);
    printf("%sok 1 - 1 / sqrt(x): worst error %.4f ulp\n", worst <= bound ? "" : "not ", worst);
    printf("%sok 2 - 4^k x gives 2^-k of it\n", scales ? "" : "not ");
    printf("%sok 3 - of zero it is finite, and large\n1..3\n", finite ? "" : "not ");
    return worst <= bound && scales && finite ? 0 : 1;
}
