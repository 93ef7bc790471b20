/* The error of core/numbers/sincos.h over its domain, on the host: iso_sincos against a reference with more digits.
 *
 * usage: sincos [STRIDE]. In float every STRIDE-th number of [2^-13, 1e4] (1, the default, is all of them) against double,
 * and below, where x and 1 are right but for the rounding of two terms, every 16th of those;
 * in double 2e7 / STRIDE numbers, random and beside the multiples of pi/4, against long double.
 * Negative arguments are compared with the positive ones.
 */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/numbers/sincos.h"

#ifdef ISO_REAL_DOUBLE
typedef long double wide; /* the reference */
#else
typedef double wide;
#endif

static const real domain = R(1e4);
static const double bound = 1.5; /* ulp of 1.0 */

typedef struct worst {
    wide error; /* absolute */
    real at;
} worst;

static worst worst_sine, worst_cosine;
static uint64_t numbers, asymmetric;

static void record(worst *const w, const wide error, const real x)
{
    const wide magnitude = error < 0 ? -error : error;
    if (!(magnitude <= w->error)) {
        w->error = magnitude;
        w->at = x;
    }
}

/* Compares at x and -x with the sine and cosine of x. */
static void compare(const real x, const wide sine, const wide cosine)
{
    const iso_sine_cosine got = iso_sincos(x);
    const iso_sine_cosine mirrored = iso_sincos(-x);
    record(&worst_sine, (wide)got.sin - sine, x);
    record(&worst_cosine, (wide)got.cos - cosine, x);
    asymmetric += mirrored.sin != -got.sin || mirrored.cos != got.cos;
    numbers++;
}

#ifdef ISO_REAL_DOUBLE

/* Vigna (2015), splitmix64. */
static uint64_t random_bits(void)
{
    static uint64_t state = 1;
    uint64_t z = (state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static double random_unit(void)
{
    return (double)(random_bits() >> 11) * 0x1p-53;
}

static void compare_double(const double x)
{
    if (x <= domain) {
        compare(x, sinl((wide)x), cosl((wide)x));
    }
}

static void sweep(const uint64_t stride)
{
    for (unsigned k = 0; k <= 12732; k++) {
        const double middle = (double)(k * 0.785398163397448309615660845819875721L);
        compare_double(middle);
        compare_double(nextafter(middle, 2e4));
        compare_double(fabs(nextafter(middle, -1.0)));
        compare_double(fabs(middle + 1e-9 * (random_unit() - 0.5)));
    }
    for (uint64_t i = 0; i < 10000000 / stride; i++) {
        compare_double(random_unit() * 1e4);
        compare_double(ldexp(1.0 + random_unit(), (int)(random_bits() % 44) - 30));
    }
}

#else

/* Below 2^-13 two terms of the series are exact to 2^-56. */
static void compare_small(const float x)
{
    const double z = (double)x * (double)x;
    compare(x, (double)x - (double)x * z / 6.0, 1.0 - z / 2.0);
}

static void sweep(const uint64_t stride)
{
    enum { SPARSE = 16 };
    const iso_bits last = iso_bits_of(domain);
    const iso_bits small = iso_bits_of(0x1p-13f);
    uint64_t b = 0;
    for (; b < small; b += SPARSE * stride) {
        compare_small(iso_real_of((iso_bits)b));
    }
    for (b = small; b <= last; b += stride) {
        const double x = (double)iso_real_of((iso_bits)b);
        compare((float)x, sin(x), cos(x));
    }
    compare(domain, sin((double)domain), cos((double)domain));
}

#endif

static bool report(const char *const name, const int number, const worst w)
{
    const double ulp = (double)(w.error / (wide)ISO_REAL_EPSILON);
    const bool good = ulp <= bound;
    printf("%sok %d - %s: worst error %.4f ulp of 1.0, at %a\n", good ? "" : "not ", number, name, ulp, (double)w.at);
    return good;
}

int main(const int argc, char **const argv)
{
    const uint64_t stride = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    if (stride == 0) {
        fprintf(stderr, "usage: %s [STRIDE]\n", argv[0]);
        return 2;
    }
    sweep(stride);
    printf("# %" PRIu64 " numbers and their negatives\n", numbers);
    bool good = report("sine", 1, worst_sine);
    good = report("cosine", 2, worst_cosine) && good;
    printf("%sok 3 - sin(-x) = -sin(x), cos(-x) = cos(x)\n", asymmetric == 0 ? "" : "not ");
    printf("1..3\n");
    return good && asymmetric == 0 ? 0 : 1;
}
