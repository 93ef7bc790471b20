/* Whether the noise of core/numbers/noise.h is white, on the host: the spectra of the numbers and of their squares,
 * also of every n-th tick; pairs in time; and of two seeds, and of two times 2^32 ticks apart, pairs, coherence and
 * correlation at every lag.
 *
 * usage: white [STRIDE|all]. Spectra are of 2^10 to 2^17 ticks and of 2^16 n-th ticks, with `all` to 2^21 and of 2^19.
 * Each figure of independent numbers has a distribution, and its surprise is the logarithm of a bound on the
 * probability of a figure at least as large: what is larger than ln(figures / 1e-6) happens to random numbers in one
 * test of a million. The same tests find a control: a generator that takes the high half of its last product as it is;
 * one whose hash is a polynomial and one round, the squares of whose 128th ticks have a line; and seeds of which one
 * has the numbers of the other some ticks later.
 */
#include "core/numbers/noise.h"

#include <complex.h>

#include "tests/core/numbers/exhaustive/measure.h"

enum { PAIRS = 18, LAGS = 64, CLASSES = 16, BANDS = 64, BLOCKS = 32, BLOCK = 13, CROSSED = 15, MOST = 21 };

typedef double complex point;
typedef double generator(uint64_t tick, uint32_t seed);

static point *numbers, *others, *roots;
static unsigned char *classes[2];

/* As CMPLX, which some compilers lack. */
static point point_of(const double re, const double im)
{
    const double parts[2] = {re, im};
    point x;
    memcpy(&x, parts, sizeof x);
    return x;
}

static double noise(const uint64_t tick, const uint32_t seed)
{
    return (double)iso_noise(tick, seed);
}

/* Nearly a sawtooth of the tick fills the space between the sums of the bits. */
static double sawtooth(const uint64_t tick, const uint32_t seed)
{
    uint32_t h = (uint32_t)tick ^ ((uint32_t)tick >> 16);
    h = h * UINT32_C(0x7FEB352D) + seed * UINT32_C(0x9E3779B9);
    const uint64_t product = (uint64_t)(h ^ (h >> 15)) * UINT32_C(0x846CA68B);
    const uint32_t hash = (uint32_t)product ^ ((uint32_t)product >> 16), between = (uint32_t)(product >> 32) & 0xFFFFFF;
    return (double)((int32_t)(iso_sum_of_pairs(hash) + between) - 412224518) * 1.3261512544296112e-08;
}

/* A cubic polynomial of the tick, which is a bijection, and one round. */
static double polynomial(const uint64_t tick, const uint32_t seed)
{
    const uint32_t x = (uint32_t)tick + iso_noise_hash(seed, 1);
    const uint32_t h = x * (x * x | 1) + seed * UINT32_C(0x7FEB352D) + (uint32_t)(tick >> 32);
    const uint64_t product = (uint64_t)(h ^ (h >> 15)) * UINT32_C(0xFD7046C5);
    const uint32_t hash = (uint32_t)product ^ ((uint32_t)product >> 16), between = (uint32_t)(product >> 40);
    return (double)((int32_t)(iso_sum_of_pairs(hash) + between) - 412140585) * 1.32620572064598e-08;
}

/* The seed is the high half of the tick. */
static double noise_of_half(const uint64_t tick, const uint32_t seed)
{
    return noise(tick + ((uint64_t)seed << 32), 1);
}

static double polynomial_of_half(const uint64_t tick, const uint32_t seed)
{
    return polynomial(tick + ((uint64_t)seed << 32), 1);
}

/* A seed is no more than another beginning. */
static double later(const uint64_t tick, const uint32_t seed)
{
    return noise(tick + 500 * (uint64_t)seed, 1);
}

/* --- how surprising --- */

/* Of the mean of n numbers exp(-x), from both sides (Chernoff); chi-square has half its degrees of freedom for n. */
static double surprise_of_mean(const double mean, const double n)
{
    return mean > 0.0 ? n * (mean - 1.0 - log(mean)) : HUGE_VAL;
}

/* Of the coherence of two spectra, each the mean of BLOCKS: (1 - c)^(BLOCKS - 1) is the probability of a larger one. */
static double surprise_of_coherence(const double c)
{
    return -(BLOCKS - 1.0) * log1p(-c);
}

static double allowed_of(const double figures)
{
    return log(figures / 1e-6);
}

static void judge(const double surprise, const double figures, const bool is_white, const char *const text)
{
    char line[200];
    const bool is_less = surprise <= allowed_of(figures);
    snprintf(line, sizeof line, "%s%s: surprise %.1f, at most %.1f", is_white ? "" : "found: ", text, surprise,
             allowed_of(figures));
    result(is_less == is_white, line);
}

/* --- transforms --- */

/* The discrete Fourier transform of 2^k points, in place (Cooley, Tukey, 1965). */
static void transform(point *const x, const int k)
{
    const size_t n = (size_t)1 << k;
    for (size_t i = 1, j = 0; i < n; i++) {
        size_t bit = n >> 1;
        for (; j & bit; bit >>= 1) {
            j ^= bit;
        }
        j ^= bit;
        if (i < j) {
            const point swap = x[i];
            x[i] = x[j];
            x[j] = swap;
        }
    }
    for (size_t half = 1; half < n; half *= 2) {
        const size_t pace = ((size_t)1 << (MOST - 1)) / half;
        for (size_t i = 0; i < n; i += 2 * half) {
            for (size_t j = 0; j < half; j++) {
                const point a = x[i + j], b = x[i + j + half], w = roots[j * pace];
                const point turned =
                    point_of(creal(b) * creal(w) - cimag(b) * cimag(w), creal(b) * cimag(w) + cimag(b) * creal(w));
                x[i + j] = a + turned;
                x[i + j + half] = a - turned;
            }
        }
    }
}

static double power_of(const point x)
{
    return creal(x) * creal(x) + cimag(x) * cimag(x);
}

static void fill(point *const to, generator *const g, const uint64_t from, const uint64_t pace, const size_t n,
                 const uint32_t seed)
{
    for (size_t i = 0; i < n; i++) {
        to[i] = g(from + i * pace, seed);
    }
    tried += n;
}

/* --- one seed --- */

typedef struct surprises {
    double line, band; /* the largest of all spectra */
    double line_figures, band_figures;
} surprises;

/* Lines are exponential, bands of them means of such. */
static void add_spectrum(surprises *const s, const int k, const bool is_squared)
{
    const size_t n = (size_t)1 << k, width = n / 2 / BANDS;
    double sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++) {
        const double x = creal(numbers[i]);
        numbers[i] = is_squared ? x * x : x;
        sum += creal(numbers[i]);
        squares += power_of(numbers[i]);
    }
    const double scale = 1.0 / (squares - sum * sum / (double)n);
    transform(numbers, k);
    for (size_t band = 0; band < BANDS; band++) {
        double mean = 0.0;
        const size_t from = band == 0 ? 1 : band * width, to = (band + 1) * width;
        for (size_t i = from; i < to; i++) {
            const double line = power_of(numbers[i]) * scale;
            s->line = fmax(s->line, line);
            mean += line / (double)(to - from);
        }
        s->band = fmax(s->band, surprise_of_mean(mean, (double)(to - from)));
    }
    s->line_figures += (double)n / 2.0;
    s->band_figures += 2.0 * BANDS;
}

/* Which spectra: of 2^least to 2^most numbers, each so many ticks behind the one before, of each seed. */
typedef struct series {
    int least, most;
    const uint32_t *paces, *seeds;
    size_t pace_count, seed_count;
} series;

static void test_spectra(generator *const g, const char *const name, const bool is_squared, const series *const of,
                         const bool is_white)
{
    surprises s = {0};
    for (size_t p = 0; p < of->pace_count; p++) {
        for (size_t i = 0; i < of->seed_count; i++) {
            for (int k = of->least; k <= of->most; k++) {
                fill(numbers, g, (uint64_t)i << (i % 4 * 11), of->paces[p], (size_t)1 << k, of->seeds[i]);
                add_spectrum(&s, k, is_squared);
            }
        }
    }
    char text[100];
    const char *const what = is_squared ? " of the squares of" : " of";
    snprintf(text, sizeof text, "a line in the spectra%s %s", what, name);
    judge(s.line, s.line_figures, is_white, text);
    if (is_white) {
        snprintf(text, sizeof text, "a band of the spectra%s %s", what, name);
        judge(s.band, s.band_figures, true, text);
    }
}

/* The sixteenths of the distribution in which the numbers are. */
static void classify(unsigned char *const to, generator *const g, const uint32_t seed)
{
    static const double edges[] = {-1.5341, -1.1503, -0.8871, -0.6745, -0.4888, -0.3186, -0.1573, 0.0,
                                   0.1573,  0.3186,  0.4888,  0.6745,  0.8871,  1.1503,  1.5341};
    for (size_t i = 0; i < ((size_t)1 << PAIRS) + LAGS; i++) {
        const double x = g(i, seed);
        to[i] = 0;
        for (size_t k = 0; k < sizeof edges / sizeof edges[0]; k++) {
            to[i] = (unsigned char)(to[i] + (x > edges[k]));
        }
    }
}

/* Chi-square of independence of the pairs (a, b) (Pearson, 1900), of 15^2 degrees of freedom. */
static double surprise_of_pairs(const unsigned char *const a, const unsigned char *const b)
{
    const double n = (double)(1 << PAIRS), freedom = (CLASSES - 1) * (CLASSES - 1);
    static double cells[CLASSES][CLASSES];
    double rows[CLASSES] = {0}, columns[CLASSES] = {0}, sum = 0.0;
    memset(cells, 0, sizeof cells);
    for (size_t i = 0; i < (size_t)1 << PAIRS; i++) {
        cells[a[i]][b[i]] += 1.0;
    }
    for (int i = 0; i < CLASSES; i++) {
        for (int j = 0; j < CLASSES; j++) {
            rows[i] += cells[i][j];
            columns[j] += cells[i][j];
        }
    }
    for (int i = 0; i < CLASSES; i++) {
        for (int j = 0; j < CLASSES; j++) {
            const double wanted = rows[i] * columns[j] / n, off = cells[i][j] - wanted;
            sum += off * off / wanted;
        }
    }
    return surprise_of_mean(sum / freedom, freedom / 2.0);
}

static void test_pairs(generator *const g, const char *const of, const uint32_t *const seeds, const size_t count,
                       const bool is_white)
{
    double in_time = 0.0, of_seeds = 0.0;
    for (size_t i = 0; i < count; i++) {
        classify(classes[0], g, seeds[i]);
        classify(classes[1], g, seeds[i] + 1);
        for (size_t lag = 1; lag <= LAGS; lag++) {
            in_time = fmax(in_time, surprise_of_pairs(classes[0], classes[0] + lag));
        }
        of_seeds = fmax(of_seeds, surprise_of_pairs(classes[0], classes[1]));
    }
    char text[100];
    judge(in_time, 2.0 * LAGS * (double)count, is_white, "pairs of ticks from 1 to 64 apart");
    snprintf(text, sizeof text, "pairs of neighbouring %s", of);
    judge(of_seeds, 2.0 * (double)count, is_white, text);
}

/* --- two seeds --- */

static double largest_coherence(generator *const g, const uint32_t a, const uint32_t b)
{
    enum { LINES = 1 << BLOCK };
    static double first[LINES], second[LINES];
    static point both[LINES];
    double largest = 0.0;
    memset(first, 0, sizeof first);
    memset(second, 0, sizeof second);
    memset(both, 0, sizeof both);
    for (size_t block = 0; block < BLOCKS; block++) {
        fill(numbers, g, block * LINES, 1, LINES, a);
        fill(others, g, block * LINES, 1, LINES, b);
        transform(numbers, BLOCK);
        transform(others, BLOCK);
        for (size_t i = 1; i < LINES / 2; i++) {
            first[i] += power_of(numbers[i]);
            second[i] += power_of(others[i]);
            both[i] += numbers[i] * conj(others[i]);
        }
    }
    for (size_t i = 1; i < LINES / 2; i++) {
        largest = fmax(largest, power_of(both[i]) / (first[i] * second[i]));
    }
    return largest;
}

/* The largest correlation at lags up to half of the numbers, in standard deviations. */
static double largest_correlation(generator *const g, const uint32_t a, const uint32_t b)
{
    const size_t n = (size_t)1 << CROSSED;
    double largest = 0.0;
    memset(numbers, 0, 2 * n * sizeof *numbers);
    memset(others, 0, 2 * n * sizeof *others);
    fill(numbers, g, 0, 1, n, a);
    fill(others, g, 0, 1, n, b);
    transform(numbers, CROSSED + 1);
    transform(others, CROSSED + 1);
    for (size_t i = 0; i < 2 * n; i++) {
        numbers[i] *= conj(others[i]);
    }
    transform(numbers, CROSSED + 1);
    for (size_t i = 0; i < 2 * n; i++) {
        const size_t lag = i < n ? i : 2 * n - i;
        if (lag <= n / 2) {
            largest = fmax(largest, fabs(creal(numbers[i])) / (double)(2 * n) / sqrt((double)(n - lag)));
        }
    }
    return largest;
}

/* Each seed with the five that follow it, and with all others in the list. A correlation is nearly Gaussian. */
static void test_seeds(generator *const g, const char *const of, const uint32_t *const seeds, const size_t count,
                       const bool is_coherent, const bool is_shifted)
{
    char text[100];
    double coherence = 0.0, correlation = 0.0;
    size_t pairs = 0;
    for (size_t i = 0; i < count; i++) {
        for (size_t j = i + 1; j < count + 5; j++, pairs++) {
            const uint32_t other = j < count ? seeds[j] : seeds[i] + (uint32_t)(j - count) + 1;
            coherence = fmax(coherence, largest_coherence(g, seeds[i], other));
            correlation = fmax(correlation, largest_correlation(g, seeds[i], other));
        }
    }
    if (!is_shifted) {
        snprintf(text, sizeof text, "the coherence of two %s", of);
        judge(surprise_of_coherence(coherence), (double)pairs * (double)(1 << (BLOCK - 1)), !is_coherent, text);
    }
    if (!is_coherent) {
        snprintf(text, sizeof text, "the correlation of two %s at some lag", of);
        judge(correlation * correlation / 2.0, 2.0 * (double)pairs * (double)(1 << CROSSED), !is_shifted, text);
    }
}

/* The seeds that isoc derives from the name of an effect (FNV-1a: Fowler, Noll, Vo). */
static uint32_t seed_of(const char *name)
{
    uint32_t hash = UINT32_C(2166136261);
    for (; *name != '\0'; name++) {
        hash = (hash ^ (unsigned char)*name) * UINT32_C(16777619);
    }
    return hash + 1;
}

static void test_noise(const uint32_t *const seeds, const size_t count, const bool all)
{
    static const uint32_t each[] = {1}, halves[] = {0, 1, 8, 512, UINT32_C(1) << 31};
    static const uint32_t paces[] = {2, 3, 4, 8, 10, 16, 32, 64, 100, 128, 256, 512, 1000, 1024, 2048, 4096};
    const size_t pace_count = sizeof paces / sizeof paces[0], half_count = sizeof halves / sizeof halves[0];
    const series ticks = {10, all ? MOST : 17, each, seeds, 1, count};
    const int k = all ? 19 : 16;
    const series paced = {k, k, paces, seeds, pace_count, all ? count : 3};
    for (int squared = 0; squared < 2; squared++) {
        test_spectra(noise, "all ticks", squared == 1, &ticks, true);
        test_spectra(noise, "every n-th tick", squared == 1, &paced, true);
    }
    test_pairs(noise, "seeds", seeds, count, true);
    test_seeds(noise, "seeds", seeds, count, false, false);
    test_pairs(noise_of_half, "high halves", halves, half_count, true);
    test_seeds(noise_of_half, "high halves", halves, half_count, false, false);
}

static void test_controls(const uint32_t *const seeds)
{
    static const uint32_t each[] = {1}, every_128[] = {128};
    const series of_one = {10, 17, each, seeds + 1, 1, 1}, paced = {16, 16, every_128, seeds + 1, 1, 1};
    test_spectra(sawtooth, "all ticks", false, &of_one, false);
    test_spectra(sawtooth, "all ticks", true, &of_one, false);
    test_spectra(polynomial, "all ticks", true, &of_one, true);
    test_spectra(polynomial, "every 128th tick", true, &paced, false);
    test_pairs(sawtooth, "seeds", seeds + 1, 1, false);
    test_seeds(sawtooth, "seeds", seeds, 3, true, false);
    test_seeds(polynomial_of_half, "high halves", seeds, 1, false, true);
    test_seeds(later, "seeds", seeds, 2, false, true);
}

int main(const int argc, char **const argv)
{
    const bool all = stride_of(argc, argv) == 0;
    const uint32_t seeds[] = {
        0, 1, 7, UINT32_C(1) << 31, seed_of("wind"), seed_of("gust1"), seed_of("gust2"), seed_of("drift")};
    enum { SEEDS = sizeof seeds / sizeof seeds[0] };
    const size_t n = (size_t)1 << MOST;
    numbers = malloc(n * sizeof *numbers);
    others = malloc(n * sizeof *others);
    roots = malloc(n / 2 * sizeof *roots);
    classes[0] = malloc(((size_t)1 << PAIRS) + LAGS);
    classes[1] = malloc(((size_t)1 << PAIRS) + LAGS);
    if (numbers != NULL && others != NULL && roots != NULL && classes[0] != NULL && classes[1] != NULL) {
        for (size_t i = 0; i < n / 2; i++) {
            const double angle = -6.283185307179586 * (double)i / (double)n;
            roots[i] = point_of(cos(angle), sin(angle));
        }
        test_noise(seeds, SEEDS, all);
        test_controls(seeds);
    }
    free(numbers);
    free(others);
    free(roots);
    free(classes[0]);
    free(classes[1]);
    return finish();
}
