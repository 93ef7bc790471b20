/* What the programs of this folder share: the arguments that are tried, and the worst error of a function.
 *
 * usage: PROGRAM [STRIDE]. Of the floats one in 211 STRIDE is tried, or every one with `all`. Around
 * each place in a list, where a function has a seam, a thousand neighbours are tried on each side. In double 2e5 /
 * STRIDE random numbers of every size, and the neighbours. References have at least 11 bits more than the result.
 */
#ifndef ISO_TESTS_EXHAUSTIVE_MEASURE_H
#define ISO_TESTS_EXHAUSTIVE_MEASURE_H

#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/numbers/real.h"

#ifdef ISO_REAL_DOUBLE
typedef long double wide; /* the reference */
enum { DIGITS = DBL_MANT_DIG, LOWEST = DBL_MIN_EXP - DBL_MANT_DIG };
#define WIDE(function) function##l
#else
typedef double wide;
enum { DIGITS = FLT_MANT_DIG, LOWEST = FLT_MIN_EXP - FLT_MANT_DIG };
#define WIDE(function) function
#endif

typedef struct worst {
    double error; /* in ulp of the reference */
    real at;
} worst;

static uint64_t tried;
static int results, failed;

/* The distance of two neighbours at the size of x. */
static inline wide ulp_of(const wide x)
{
    int exponent;
    (void)WIDE(frexp)(x, &exponent);
    exponent = x == 0 || exponent - DIGITS < LOWEST ? LOWEST : exponent - DIGITS;
    return WIDE(ldexp)(1, exponent);
}

static inline void compare(worst *const w, const real got, const wide want, const real x)
{
    const double error = (double)(WIDE(fabs)((wide)got - want) / ulp_of(want));
    tried++;
    if (!(error <= w->error)) {
        *w = (worst){error, x};
    }
}

static inline void result(const bool good, const char *const name)
{
    results++;
    failed += !good;
    printf("%sok %d - %s\n", good ? "" : "not ", results, name);
}

static inline void bounded(const worst w, const double bound, const char *const name)
{
    char text[160];
    snprintf(text, sizeof text, "%s: worst error %.4f ulp, at %a, bound %g", name, w.error, (double)w.at, bound);
    result(w.error <= bound, text);
}

/* Vigna (2015), splitmix64. */
static inline uint64_t random_bits(void)
{
    static uint64_t state = 1;
    uint64_t z = (state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

/* A random number of a random size up to 2^scale. */
static inline real random_real(const int scale)
{
    const double size = ldexp(1.0 + (double)(random_bits() >> 12) * 0x1p-52, scale - 1 - (int)(random_bits() % 60));
    return (real)(random_bits() & 1 ? -size : size);
}

/* 0 for every number there is. */
static inline uint64_t stride_of(const int argc, char **const argv)
{
    if (argc > 1 && strcmp(argv[1], "all") == 0) {
        return 0;
    }
    const uint64_t stride = argc > 1 ? strtoull(argv[1], NULL, 10) : 1;
    if (stride == 0) {
        fprintf(stderr, "usage: %s [STRIDE|all]\n", argv[0]);
        exit(2);
    }
    return stride;
}

/* Calls `each` for numbers from 0 to most and their negatives, and beside the places. */
static inline void sweep(const uint64_t stride, const real most, const real *const places, const int count,
                         void (*const each)(real x))
{
    enum { SPARSE = 211, BESIDE = 1000, RANDOM = 200000 };
    const iso_bits last = iso_bits_of(most);
    for (int i = 0; i < count; i++) {
        for (iso_bits b = iso_bits_of(places[i]) - BESIDE; b != iso_bits_of(places[i]) + BESIDE; b++) {
            each(iso_real_of(b));
        }
    }
#ifdef ISO_REAL_DOUBLE
    for (uint64_t i = 0; i < RANDOM / (stride == 0 ? 1 : stride); i++) {
        const real x = random_real(ilogb(most) + 1);
        each(iso_abs(x) <= most ? x : most);
    }
#else
    for (uint64_t b = 0; b <= last; b += stride == 0 ? 1 : SPARSE * stride) {
        each(iso_real_of((iso_bits)b));
        each(-iso_real_of((iso_bits)b));
    }
#endif
    each(iso_real_of(last));
    each(-iso_real_of(last));
}

static inline int finish(void)
{
    printf("# %" PRIu64 " numbers\n1..%d\n", tried, results);
    return failed > 0;
}

#endif
