/* The statistics of core/numbers/noise.h, on the host: moments, distribution, and correlations in time and between
 * seeds.
 *
 * usage: noise [STRIDE|all]. With `all` the moments of the numbers of all hashes, of which the 2^32 ticks of a high
 * half have each one. 2^20 / STRIDE ticks of each of four seeds, 0 and 1 among them. Each figure is compared with what
 * N independent numbers would have, within five of its standard deviations: 5 / sqrt(N) of a mean or a correlation, 5
 * sqrt(2 / N) of a variance, 5 sqrt(24 / N) of a kurtosis; 5 / sqrt(N) of a distribution function, to which the
 * straight lines of the density add 2e-3.
 */
#include "core/numbers/noise.h"

#include "tests/core/numbers/exhaustive/measure.h"

enum { MOST = 1 << 20, LAGS = 64 };

#ifdef PLANTED
/* Only half of the ticks are told apart. */
#define iso_noise(tick, seed) iso_noise((tick) & ~UINT32_C(1), seed)
#endif

static real *numbers, *others;
static size_t count;

static void check(const double got, const double want, const double allowed, const char *const name,
                  const unsigned seed)
{
    char text[160];
    snprintf(text, sizeof text, "seed %u: %s %.6f, wanted %g +- %.2g", seed, name, got, want, allowed);
    result(fabs(got - want) <= allowed, text);
}

static double correlation(const real *const a, const real *const b, const size_t n)
{
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        sum += (double)a[i] * (double)b[i];
    }
    return sum / (double)n;
}

/* Sums of 2^16 at a time: rounding takes less than 1e-11. */
static void test_all_hashes(void)
{
    double sums[5] = {0};
    for (uint32_t high = 0; high < 1 << 16; high++) {
        double some[5] = {0};
        for (uint32_t low = 0; low < 1 << 16; low++) {
            const double x = (double)iso_gaussian(high << 16 | low);
            some[1] += x;
            some[2] += x * x;
            some[3] += x * x * x;
            some[4] += x * x * x * x;
        }
        for (int k = 1; k < 5; k++) {
            sums[k] += some[k] * 0x1p-32;
        }
    }
    /* The factor is rounded to half an ulp, and stands in the variance twice. */
    const double rounding = 1e-8 + (double)ISO_REAL_EPSILON, kurtosis = sums[4] - 3.0;
    char text[160];
    snprintf(text, sizeof text, "all hashes: mean %.2g, variance 1 %+.2g, skewness %.2g, excess kurtosis %.5f", sums[1],
             sums[2] - 1.0, sums[3], kurtosis);
    result(fabs(sums[1]) <= 1e-8 && fabs(sums[2] - 1.0) <= rounding && fabs(sums[3]) <= 1e-7 &&
               fabs(kurtosis + 0.0843) <= 5e-5,
           text);
}

static void test_moments(const unsigned seed)
{
    const double n = (double)count;
    double sums[5] = {0}, largest = 0.0;
    for (size_t i = 0; i < count; i++) {
        double power = 1.0;
        for (int k = 0; k < 5; k++) {
            sums[k] += power;
            power *= (double)numbers[i];
        }
        largest = fmax(largest, fabs((double)numbers[i]));
    }
    check(sums[1] / n, 0.0, 5.0 / sqrt(n), "mean", seed);
    check(sums[2] / n, 1.0, 5.0 * sqrt(2.0 / n), "variance", seed);
    check(sums[3] / n, 0.0, 5.0 * sqrt(6.0 / n), "skewness", seed);
    check(sums[4] / n - 3.0, -0.0843, 5.0 * sqrt(24.0 / n), "excess kurtosis", seed);
    result(largest > 4.0 && largest < 6.0, "the largest is beyond 4 and within 6");
}

/* The distribution function against that of Gauss. */
static void test_distribution(const unsigned seed)
{
    enum { BINS = 200 };
    size_t bins[BINS] = {0}, below = 0;
    for (size_t i = 0; i < count; i++) {
        const double place = ((double)numbers[i] + 5.0) * (BINS / 10.0);
        bins[place < 0.0 ? 0 : place >= BINS ? BINS - 1 : (int)place]++;
    }
    double worst_off = 0.0;
    for (int i = 0; i < BINS - 1; i++) {
        below += bins[i];
        const double place = (i + 1) * (10.0 / BINS) - 5.0;
        worst_off = fmax(worst_off, fabs((double)below / (double)count - 0.5 * erfc(-place / sqrt(2.0))));
    }
    check(worst_off, 0.0, 5.0 / sqrt((double)count) + 2e-3, "distance from the distribution function", seed);
}

/* Correlations up to 63 ticks apart: a white spectrum. */
static void test_spectrum(const unsigned seed)
{
    double largest = 0.0;
    for (size_t lag = 1; lag < LAGS; lag++) {
        largest = fmax(largest, fabs(correlation(numbers, numbers + lag, count - lag)));
    }
    check(largest, 0.0, 5.0 / sqrt((double)count), "largest correlation with a later tick", seed);
    check(correlation(numbers, others, count), 0.0, 5.0 / sqrt((double)count), "correlation with another seed", seed);
}

static void fill(real *const to, const unsigned seed)
{
    for (size_t i = 0; i < count; i++) {
        to[i] = iso_noise((uint32_t)i, seed);
    }
}

int main(const int argc, char **const argv)
{
    static const unsigned seeds[] = {0, 1, 12345, 0x9E3779B9};
    const uint64_t stride = stride_of(argc, argv);
    count = MOST / (stride == 0 ? 1 : stride);
    if (stride == 0) {
        test_all_hashes();
    }
    numbers = malloc(count * sizeof *numbers);
    others = malloc(count * sizeof *others);
    for (size_t i = 0; numbers != NULL && others != NULL && i < sizeof seeds / sizeof seeds[0]; i++) {
        fill(numbers, seeds[i]);
        fill(others, seeds[i] + 1);
        test_moments(seeds[i]);
        test_distribution(seeds[i]);
        test_spectrum(seeds[i]);
    }
    tried = count * sizeof seeds / sizeof seeds[0];
    free(numbers);
    free(others);
    return finish();
}
