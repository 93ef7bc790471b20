/* The error of core/numbers/sincos.h over its domain, on the host: iso_sincos against a reference with more digits.
 *
 * usage: sincos [STRIDE [TURN]], or sincos all. In float one in 5 STRIDE numbers of [2^-13, 1e4] (STRIDE is 1 if it is
 * not given) against double, from the number TURN modulo 5 on, so that five turns try them all; `all` tries all at
 * once. The 64 numbers beside each multiple of pi/4, where the reduction has its seams and cancels, and the last 4096
 * of the domain are always tried. Below 2^-13, where x and 1 are right but for the rounding of two terms, it is one in
 * 80 STRIDE. In double 4e6 / STRIDE random numbers, others with every TURN, and those beside the multiples of pi/4,
 * against long double; with `all` 2e7. Negative arguments are compared with the positive ones.
 */
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/numbers/sincos.h"

#ifdef ISO_REAL_DOUBLE
typedef long double wide; /* the reference */
#else
typedef double wide;
#endif

static const real domain = R(1e4);
static const double sine_bound = 1.03, cosine_bound = 1.48; /* ulp of 1.0; core/README.md has them */

typedef struct worst {
    wide error; /* absolute */
    real at;
} worst_error;

static worst_error worst_sine, worst_cosine;

/* sin^2 + cos^2 - 1 in each part of a half turn: what stays of it on average lengthens or shortens whatever is turned,
 * in every step, and a rounding does not. A coefficient that is only rounded leaves 0.3 ulp. */
enum { SLICES = 12 };
static const double bias_bound = 0.1; /* ulp of 1.0 */
static wide norm_sum[SLICES];
static uint64_t norm_count[SLICES];
static uint64_t numbers, asymmetric;

enum { PARTS = 5, MULTIPLES = 12732 }; /* of pi/4 in the domain */
static const long double quarter_pi = 0.785398163397448309615660845819875721L;

static void record(worst_error *const w, const wide error, const real x)
{
    const wide magnitude = error < 0 ? -error : error;
    if (!(magnitude <= w->error)) {
        w->error = magnitude;
        w->at = x;
    }
}

static void record_norm(const real x)
{
    const iso_sine_cosine got = iso_sincos(x);
    const double halves = (double)x / (4.0 * (double)quarter_pi);
    const int slice = (int)((halves - floor(halves)) * SLICES);
    const wide sine = (wide)got.sin, cosine = (wide)got.cos;
    norm_sum[slice] += (sine * sine - 1) + cosine * cosine;
    norm_count[slice]++;
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
static uint64_t random_state;

static uint64_t random_bits(void)
{
    uint64_t z = (random_state += UINT64_C(0x9E3779B97F4A7C15));
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

static void sweep(const uint64_t stride, const uint64_t turn)
{
    random_state = 1 + (turn << 32);
    for (unsigned k = 0; k <= MULTIPLES; k++) {
        const double middle = (double)(k * quarter_pi);
        compare_double(middle);
        compare_double(nextafter(middle, 2e4));
        compare_double(fabs(nextafter(middle, -1.0)));
        compare_double(fabs(middle + 1e-9 * (random_unit() - 0.5)));
    }
    for (uint64_t i = 0; i < 10000000 / stride; i++) {
        const double x = random_unit() * 1e4;
        compare_double(x);
        record_norm(x);
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

static void compare_float(const float x)
{
    compare(x, sin((double)x), cos((double)x));
}

static void sweep(const uint64_t stride, const uint64_t turn)
{
    enum { SPARSE = 16, BESIDE = 32, LAST = 4096 };
    const iso_bits last = iso_bits_of(domain);
    const iso_bits small = iso_bits_of(0x1p-13f);
    uint64_t b = 0;
    for (; b < small; b += SPARSE * stride) {
        compare_small(iso_real_of((iso_bits)b));
    }
    for (b = small + turn % stride; b <= last; b += stride) {
        compare_float(iso_real_of((iso_bits)b));
        record_norm(iso_real_of((iso_bits)b));
    }
    for (unsigned k = 1; k <= MULTIPLES; k++) {
        const iso_bits middle = iso_bits_of((float)(k * quarter_pi));
        for (b = middle - BESIDE; b < middle + BESIDE && b <= last; b++) {
            compare_float(iso_real_of((iso_bits)b));
        }
    }
    for (b = last - LAST; b <= last; b++) {
        compare_float(iso_real_of((iso_bits)b));
    }
}

#endif

static bool report(const char *const name, const int number, const worst_error w, const double bound)
{
    const double ulp = (double)(w.error / (wide)ISO_REAL_EPSILON);
    const bool good = ulp <= bound;
    printf("%sok %d - %s: worst error %.4f ulp of 1.0, at %a\n", good ? "" : "not ", number, name, ulp, (double)w.at);
    return good;
}

static bool report_bias(void)
{
    double worst = 0;
    for (int i = 0; i < SLICES; i++) {
        const double ulp = fabs((double)(norm_sum[i] / (wide)norm_count[i] / (wide)ISO_REAL_EPSILON));
        worst = ulp > worst ? ulp : worst;
    }
    const bool good = worst <= bias_bound;
    printf("%sok 4 - sin^2 + cos^2 - 1: at most %.4f ulp on average over a part of a half turn\n", good ? "" : "not ",
           worst);
    return good;
}

int main(const int argc, char **const argv)
{
    const bool all = argc > 1 && strcmp(argv[1], "all") == 0;
    const uint64_t stride = all ? 1 : PARTS * (argc > 1 ? strtoull(argv[1], NULL, 10) : 1);
    const uint64_t turn = argc > 2 ? strtoull(argv[2], NULL, 10) % PARTS : 0;
    if (stride == 0) {
        fprintf(stderr, "usage: %s [STRIDE [TURN]|all]\n", argv[0]);
        return 2;
    }
    sweep(stride, turn);
    printf("# turn %" PRIu64 ", one in %" PRIu64 ": %" PRIu64 " numbers and their negatives\n", turn, stride, numbers);
    bool good = report("sine", 1, worst_sine, sine_bound);
    good = report("cosine", 2, worst_cosine, cosine_bound) && good;
    printf("%sok 3 - sin(-x) = -sin(x), cos(-x) = cos(x)\n", asymmetric == 0 ? "" : "not ");
    good = report_bias() && good;
    printf("1..4\n");
    return good && asymmetric == 0 ? 0 : 1;
}
