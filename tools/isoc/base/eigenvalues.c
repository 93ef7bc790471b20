#include "tools/isoc/base/numbers.h"

#include <float.h>
#include <math.h>

enum { ITERATIONS = 300, EXCEPTIONAL = 10 };

typedef struct square {
    double *at; /* [n][n] */
    int n;
} square;

static double *entry(const square *m, int row, int column)
{
    return &m->at[row * m->n + column];
}

/* Scales row i by 1/f and column i by f, a power of two that makes them nearly equal. Returns whether that helped. */
static bool scale(const square *m, int i)
{
    double row = 0.0, column = 0.0, f = 1.0; /* the sums of both, but for the diagonal */
    for (int j = 0; j < m->n; j++) {
        row += j == i ? 0.0 : fabs(*entry(m, i, j));
        column += j == i ? 0.0 : fabs(*entry(m, j, i));
    }
    if (row == 0.0 || column == 0.0) {
        return false;
    }
    const double before = row + column;
    for (; column < row / 2.0; column *= 4.0) {
        f *= 2.0;
    }
    for (; column >= row * 2.0; column /= 4.0) {
        f /= 2.0;
    }
    if ((row + column) / f >= 0.95 * before) {
        return false;
    }
    for (int j = 0; j < m->n; j++) {
        *entry(m, i, j) /= f;
    }
    for (int j = 0; j < m->n; j++) {
        *entry(m, j, i) *= f;
    }
    return true;
}

static void balance(const square *m)
{
    bool again = true;
    for (int sweep = 0; again && sweep < ITERATIONS; sweep++) {
        again = false;
        for (int i = 0; i < m->n; i++) {
            again = scale(m, i) || again;
        }
    }
}

double largest_of(const double *v, int count)
{
    double largest = 0.0;
    for (int i = 0; i < count; i++) {
        largest = fabs(v[i]) > largest ? fabs(v[i]) : largest;
    }
    return largest;
}

/* Makes v the vector of the reflection 1 - beta v v' that leaves only the first element of v. Returns beta. */
static double reflector(double *v, int count)
{
    const double largest = largest_of(v, count);
    double square_of_length = 0.0;
    if (largest == 0.0) {
        return 0.0;
    }
    for (int i = 0; i < count; i++) {
        v[i] /= largest;
        square_of_length += v[i] * v[i];
    }
    const double length = sqrt(square_of_length), first = fabs(v[0]);
    v[0] += v[0] < 0.0 ? -length : length;
    return 1.0 / (square_of_length + length * first);
}

/* Reflects rows and columns `first` to first + count - 1: in the columns from `left` on, and the rows to `last`. */
static void reflect(const square *m, const double *v, double beta, int first, int count, int left, int last)
{
    for (int j = left; j < m->n; j++) {
        double sum = 0.0;
        for (int i = 0; i < count; i++) {
            sum += v[i] * *entry(m, first + i, j);
        }
        for (int i = 0; i < count; i++) {
            *entry(m, first + i, j) -= beta * sum * v[i];
        }
    }
    for (int i = 0; i <= last; i++) {
        double sum = 0.0;
        for (int j = 0; j < count; j++) {
            sum += v[j] * *entry(m, i, first + j);
        }
        for (int j = 0; j < count; j++) {
            *entry(m, i, first + j) -= beta * sum * v[j];
        }
    }
}

static void reduce(arena *memory, const square *m)
{
    const int n = m->n;
    double *v = arena_take(memory, (size_t)n + 1, sizeof *v);
    for (int k = 0; k < n - 2; k++) {
        for (int i = k + 1; i < n; i++) {
            v[i - k - 1] = *entry(m, i, k);
        }
        const double beta = reflector(v, n - k - 1);
        reflect(m, v, beta, k + 1, n - k - 1, k, n - 1);
        for (int i = k + 2; i < n; i++) {
            *entry(m, i, k) = 0.0;
        }
    }
    arena_return(memory, v, (size_t)n + 1, sizeof *v);
}

/* One step on the block from `low` to `high`, with the eigenvalues of its last two rows as shifts. */
static void francis(const square *m, int low, int high, bool exceptional)
{
    const double a = *entry(m, high - 1, high - 1), b = *entry(m, high - 1, high);
    const double c = *entry(m, high, high - 1), d = *entry(m, high, high);
    const double off = fabs(c) + fabs(*entry(m, high - 1, high - 2));
    const double h11 = *entry(m, low, low), h21 = *entry(m, low + 1, low), h22 = *entry(m, low + 1, low + 1);
    /* The shifts less h11, their sum and their product; exceptional ones are beside the last entry. */
    const double first = a - h11, last = d - h11;
    const double sum = exceptional ? 2.0 * last + 1.5 * off : first + last;
    const double product = exceptional ? last * last + 1.5 * off * last + off * off : first * last - b * c;
    double v[3] = {*entry(m, low, low + 1) * h21 + product, h21 * ((h22 - h11) - sum),
                   h21 * *entry(m, low + 2, low + 1)};
    for (int k = low; k < high; k++) {
        const int count = k < high - 1 ? 3 : 2, left = k > low ? k - 1 : low;
        const double beta = reflector(v, count);
        reflect(m, v, beta, k, count, left, k + count < high ? k + count : high);
        for (int i = 1; k > low && i < count; i++) {
            *entry(m, k + i, k - 1) = 0.0;
        }
        for (int i = 0; i < 3; i++) {
            v[i] = k + 1 + i <= high ? *entry(m, k + 1 + i, k) : 0.0;
        }
    }
}

/* Where the block that ends at `high` begins: an entry below the diagonal that is lost beside its neighbours, or where
 * these are zero, beside the whole. */
static int block_start(const square *m, int high, double whole)
{
    int low = high;
    for (; low > 0; low--) {
        const double beside = fabs(*entry(m, low, low)) + fabs(*entry(m, low - 1, low - 1));
        if (fabs(*entry(m, low, low - 1)) <= DBL_EPSILON * (beside == 0.0 ? whole : beside)) {
            *entry(m, low, low - 1) = 0.0;
            break;
        }
    }
    return low;
}

/* The eigenvalues of the block of rows and columns `low` and low + 1. */
static void pair(const square *m, int low, double *re, double *im)
{
    const double a = *entry(m, low, low), b = *entry(m, low, low + 1);
    const double c = *entry(m, low + 1, low), d = *entry(m, low + 1, low + 1);
    const double middle = (a - d) / 2.0, under = middle * middle + b * c;
    if (under < 0.0) {
        re[low] = re[low + 1] = (a + d) / 2.0;
        im[low] = sqrt(-under);
        im[low + 1] = -im[low];
        return;
    }
    const double larger = middle + (middle < 0.0 ? -sqrt(under) : sqrt(under));
    re[low] = d + larger;
    re[low + 1] = larger == 0.0 ? d : d - b * c / larger;
    im[low] = im[low + 1] = 0.0;
}

/* The eigenvalues of a Hessenberg matrix; false where the iterations do not end. */
static bool iterate(const square *m, double *re, double *im)
{
    const double whole = largest_of(m->at, m->n * m->n);
    for (int high = m->n - 1, iteration = 0; high >= 0; iteration++) {
        const int low = block_start(m, high, whole);
        if (low < high - 1) {
            if (iteration == ITERATIONS) {
                return false;
            }
            francis(m, low, high, iteration % EXCEPTIONAL == EXCEPTIONAL - 1);
            continue;
        }
        if (low == high) {
            re[high] = *entry(m, high, high);
            im[high] = 0.0;
        } else {
            pair(m, low, re, im);
        }
        high = low - 1;
        iteration = -1;
    }
    return true;
}

bool eigenvalues(arena *memory, const double *a, int n, double *re, double *im)
{
    const size_t size = (size_t)(n * n) + 1;
    const square m = {arena_take(memory, size, sizeof *a), n};
    bool good = true;
    for (int i = 0; i < n * n; i++) {
        m.at[i] = a[i];
        good = good && isfinite(a[i]);
    }
    if (good) {
        balance(&m);
        reduce(memory, &m);
        good = iterate(&m, re, im);
    }
    arena_return(memory, m.at, size, sizeof *a);
    return good;
}
