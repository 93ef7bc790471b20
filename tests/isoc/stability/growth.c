/* What isoc derives from the kernels (tools/isoc/method/growth.h) against what is published (theory.h):
 * growth at random z, also of checked, compensated and smooth forms, and the limits. In double. */
#include <math.h>
#include <stdint.h>

#include "core/methods/all.h"
#include "core/methods/table.h"
#include "tests/host/report.h"
#include "tests/isoc/stability/theory.h"
#include "tools/isoc/method/growth.h"
#include "tools/isoc/method/step_map.h"

enum { TRIES = 400 };

/* Roots of the published polynomial and eigenvalues of the step are each off by some ten roundings of their
 * coefficients, as often as a root is ill-conditioned: by 1 / (distance to the next one), for which there is a factor
 * of a thousand. The limits are told to four decimals. */
static const double tolerance = 1e4 * 0x1p-52, decimals = 1e-4;

static const char *const names[ISO_METHODS] = ISO_METHOD_NAMES;
static const uint64_t seed = 20261122;
static uint64_t state;

/* Uniform in [0, 1): Knuth's linear congruential generator MMIX. */
static double uniform(void)
{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 11) * 0x1p-53;
}

/* In the left half plane, on its edge and on the real axis, of 1e-3 to 10; of an implicit method to 1000, since
 * elimination without a pivot search loses as much. */
static double complex random_z(const unsigned method, const int i)
{
    const double angle = acos(-1.0) * (i % 4 == 0 ? 0.5 : i % 4 == 1 ? 1.0 : 0.5 + 0.5 * uniform());
    const double size = pow(10.0, -3.0 + (ISO_IS_IMPLICIT(method) ? 6.0 : 4.0) * uniform());
    return i % 4 == 1 ? -size : size * (cos(angle) + sin(angle) * IMAGINARY);
}

/* The largest difference, over the larger of a growth and one. */
static double worst_of(const unsigned method, const unsigned published)
{
    double worst = 0.0;
    for (int i = 0; i < TRIES; i++) {
        arena *memory = arena_new();
        const double complex z = random_z(method, i);
        const double known = theory_growth(published, z);
        const double off = fabs(growth_of(memory, method, creal(z), cimag(z)) - known) / fmax(known, 1.0);
        worst = off > worst ? off : worst;
        arena_free(memory);
    }
    return worst;
}

static void test_growth(const unsigned method)
{
    const double worst = worst_of(method, method);
    report_ok(worst <= tolerance, "%s: the growth of its kernel is the published one at %d random z, to %.1e",
              names[method], TRIES, worst);
}

/* The step with all that the options keep, against that without. */
static void test_options(const unsigned method)
{
    static const unsigned options[] = {ISO_COMPENSATED, ISO_CHECKED, ISO_SMOOTH, ISO_CHECKED | ISO_COMPENSATED,
                                       ISO_CHECKED | ISO_SMOOTH};
    double worst = 0.0;
    for (int i = 0; i < TRIES / 4; i++) {
        arena *memory = arena_new();
        const double complex z = 0.3 * random_z(ISO_EULER, 2);
        const double jacobian[] = {0.0, cabs(z), -cabs(z), 2.0 * creal(z)};
        const linear_plant of = {jacobian, 2, 1};
        const double known = growth_of(memory, method, creal(z), cimag(z));
        int n;
        const double *map = step_map(memory, method | options[i % 5], &of, 1.0, &n);
        worst = fmax(worst, fabs(growth_of_map(memory, map, n) - known) / fmax(known, 1.0));
        arena_free(memory);
    }
    report_ok(worst <= tolerance, "%s: compensated, checked and smooth, it grows as without, to %.1e", names[method],
              worst);
}

/* The first |z| along a ray, of angle from the negative real axis, where the published growth passes one. */
static double published_limit(const unsigned method, const double complex ray, const double end)
{
    double low = 0.0, high = 0.05;
    while (high < end && theory_growth(method, high * ray) <= 1.0 + 1e-9) {
        low = high;
        high *= 1.05;
    }
    if (high >= end) {
        return end;
    }
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        *(theory_growth(method, middle * ray) <= 1.0 + 1e-9 ? &low : &high) = middle;
    }
    return low;
}

/* Of a rate, and of an oscillation with a tenth of critical damping: what an implicit method follows ends at 4 and 2.
 */
static void test_limits(const unsigned method)
{
    const bool implicit = ISO_IS_IMPLICIT(method);
    const double rate = published_limit(method, -1.0, implicit ? 4.0 : 50.0);
    const double frequency = published_limit(method, -0.1 + sqrt(0.99) * IMAGINARY, implicit ? 2.0 : 50.0);
    const stability_limits found = limits_of(method);
    report_ok(fabs(found.rate - rate) <= decimals && fabs(found.frequency - frequency) <= decimals,
              "%s: its limits are %.4f and %.4f; published, %.5f and %.5f", names[method], found.rate, found.frequency,
              rate, frequency);
}

int main(void)
{
    report_note("seed %llu", (unsigned long long)seed);
    state = seed;
    for (unsigned method = 0; method < ISO_METHODS; method++) {
        if (isnan(theory_growth(method, -0.1))) {
            report_note("%s: nothing is published here", names[method]);
            continue;
        }
        test_growth(method);
        test_options(method);
        test_limits(method);
    }
    report_ok(worst_of(ISO_ABM4, ISO_ABM4_PECECE) > tolerance, "control: the growth of another method is noticed");
    return report_done();
}
