/* tools/isoc/base/eigenvalues.c against closed forms. The QR iteration is backward stable: what it finds are
 * eigenvalues of a matrix that is off by some n epsilon of the norm. Those of a normal matrix are then off by as much
 * (Bauer and Fike 1960); the roots of a polynomial, from its companion matrix, are those of one whose coefficients are
 * off by some n epsilon of the square of the norm (Edelman and Murakami 1995). */
#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdint.h>

#include "tests/host/report.h"
#include "tools/isoc/base/numbers.h"

enum { MOST = 60, TRIES = 40, ROUNDINGS = 10 };
static const uint64_t seed = 20261122;
static uint64_t state;
static double re[MOST], im[MOST];

/* Uniform in [-1, 1): Knuth's linear congruential generator MMIX. */
static double uniform(void)
{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 11) * 0x1p-52 - 1.0;
}

/* a = (1 - 2 v v') a (1 - 2 v v') for a random unit vector v. */
static void turn(double *a, int n)
{
    double v[MOST], length = 0.0;
    for (int i = 0; i < n; i++) {
        v[i] = uniform();
        length += v[i] * v[i];
    }
    for (int side = 0; side < 2; side++) {
        const int along = side == 0 ? 1 : n, across = side == 0 ? n : 1;
        for (int i = 0; i < n; i++) {
            double sum = 0.0;
            for (int j = 0; j < n; j++) {
                sum += a[i * along + j * across] * v[j];
            }
            for (int j = 0; j < n; j++) {
                a[i * along + j * across] -= 2.0 * sum * v[j] / length;
            }
        }
    }
}

/* The largest distance of an eigenvalue that was expected from the nearest one found, each taken once. */
static double distance(const double complex *wanted, int n)
{
    bool taken[MOST] = {false};
    double worst = 0.0;
    for (int i = 0; i < n; i++) {
        int nearest = 0;
        double least = HUGE_VAL;
        for (int j = 0; j < n; j++) {
            const double off = hypot(re[j] - creal(wanted[i]), im[j] - cimag(wanted[i]));
            if (!taken[j] && off < least) {
                nearest = j;
                least = off;
            }
        }
        taken[nearest] = true;
        worst = fmax(worst, least);
    }
    return worst;
}

/* Blocks on the diagonal, real ones and pairs, turned; with `spread`, in units that differ by powers of ten. */
static void test_normal(arena *memory, int n, double spread)
{
    double worst = 0.0;
    bool good = true;
    for (int t = 0; t < TRIES; t++) {
        double a[MOST * MOST] = {0.0}, off;
        double complex wanted[MOST];
        for (int i = 0; i < n; i++) {
            const double x = uniform(), y = uniform();
            const bool is_pair = i + 1 < n && t % 2 == 0;
            a[i * n + i] = x;
            wanted[i] = x;
            if (is_pair) {
                a[i * n + i + 1] = y;
                a[(i + 1) * n + i] = -y;
                a[(i + 1) * n + i + 1] = x;
                wanted[i] = x + y * (double complex)I;
                wanted[i + 1] = conj(wanted[i]);
                i++;
            }
        }
        turn(a, n);
        turn(a, n);
        for (int i = 0; i < n * n; i++) {
            a[i] *= pow(spread, i / n % 7 - i % n % 7);
        }
        good = eigenvalues(memory, a, n, re, im) && good;
        off = distance(wanted, n);
        worst = fmax(worst, off);
    }
    /* The norm is at most sqrt(2). */
    report_ok(good && worst <= ROUNDINGS * n * DBL_EPSILON * sqrt(2.0),
              "%d normal matrices of size %d, units by %g: eigenvalues to %.1f epsilon", TRIES, n, spread,
              worst / DBL_EPSILON);
}

/* z^n + c[n-1] z^(n-1) + ... + c[0]. */
static void companion(double *a, const double *c, int n)
{
    for (int i = 0; i < n * n; i++) {
        a[i] = i / n == i % n + 1 ? 1.0 : 0.0;
    }
    for (int i = 0; i < n; i++) {
        a[i * n + n - 1] = -c[i];
    }
}

static void test_polynomials(arena *memory, int n)
{
    double worst = 0.0;
    bool good = true;
    for (int t = 0; t < TRIES; t++) {
        double c[MOST], a[MOST * MOST], norm = 1.0;
        for (int i = 0; i < n; i++) {
            c[i] = 4.0 * uniform();
            norm += c[i] * c[i];
        }
        companion(a, c, n);
        good = eigenvalues(memory, a, n, re, im) && good;
        for (int i = 0; i < n; i++) {
            const double complex z = re[i] + im[i] * (double complex)I;
            double complex value = 1.0;
            double sum = 1.0;
            for (int k = n; k-- > 0;) {
                value = value * z + c[k];
                sum = sum * cabs(z) + 1.0;
            }
            worst = fmax(worst, cabs(value) / (norm * sum));
        }
    }
    report_ok(good && worst <= ROUNDINGS * n * DBL_EPSILON, "%d companion matrices of size %d: roots to %.1f epsilon",
              TRIES, n, worst / DBL_EPSILON);
}

/* z^n = 1: the companion matrix is a permutation. z^2 = 0: a double root, known to the root of an epsilon. */
static void test_known(arena *memory)
{
    const double nilpotent[] = {0.0, 1.0, 0.0, 0.0}, wrong[] = {(double)NAN, 1.0, 1.0, 0.0};
    for (int n = 2; n <= 7; n++) {
        double c[MOST] = {-1.0}, a[MOST * MOST];
        double complex wanted[MOST];
        for (int i = 0; i < n; i++) {
            wanted[i] = cexp(2.0 * acos(-1.0) * i / n * (double complex)I);
        }
        companion(a, c, n);
        report_ok(eigenvalues(memory, a, n, re, im) && distance(wanted, n) <= ROUNDINGS * n * DBL_EPSILON,
                  "the %d roots of one", n);
        wanted[0] = 1.0 + 2.0 * ROUNDINGS * n * DBL_EPSILON;
        report_ok(distance(wanted, n) > ROUNDINGS * n * DBL_EPSILON, "control: another root is noticed");
    }
    report_ok(eigenvalues(memory, nilpotent, 2, re, im) && hypot(re[0], im[0]) <= 2.0 * sqrt(DBL_EPSILON), "z^2 = 0");
    report_ok(!eigenvalues(memory, wrong, 2, re, im), "a matrix that is not finite has none");
}

/* The step of a mechanism: bodies that move freely, blocks of 1 and h beside each other, h to 10^4, of which rounding
 * moves a pair by the norm times the root of n epsilon; and what decays. The iterations end. */
static void test_clusters(arena *memory, int n)
{
    double worst = 0.0;
    int ended = 0;
    for (int t = 0; t < TRIES; t++) {
        double a[MOST * MOST] = {0.0};
        double complex wanted[MOST];
        for (int i = 0; i < n; i++) {
            const bool is_free = i < n / 2 * 2 - 2;
            wanted[i] = is_free ? 1.0 : uniform();
            a[i * n + i] = creal(wanted[i]);
            if (is_free && i % 2 == 0) {
                a[i * n + i + 1] = pow(10.0, 4.0 * uniform());
            }
        }
        turn(a, n);
        ended += eigenvalues(memory, a, n, re, im);
        worst = fmax(worst, distance(wanted, n));
    }
    report_ok(ended == TRIES && worst <= 1e4 * sqrt(ROUNDINGS * n * DBL_EPSILON),
              "%d matrices of size %d with eigenvalues that are all but equal: the iterations end for %d, to %.1e",
              TRIES, n, ended, worst);
}

int main(void)
{
    arena *memory = arena_new();
    state = seed;
    report_note("seed %llu", (unsigned long long)seed);
    test_normal(memory, 2, 1.0);
    test_normal(memory, 7, 1.0);
    test_normal(memory, 7, 100.0);
    test_normal(memory, MOST, 1.0);
    test_polynomials(memory, 3);
    test_polynomials(memory, 8);
    test_known(memory);
    test_clusters(memory, 6);
    test_clusters(memory, 12);
    test_clusters(memory, 30);
    arena_free(memory);
    return report_done();
}
