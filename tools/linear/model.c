#include "tools/linear/linear.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/file/file.h"

static _Noreturn void fail(const char *path, const char *word)
{
    quit("linear: %s is no linear model: %s", path, word);
}

/* The count behind a word. */
static int read_count(FILE *const from, const char *const path, const char *const word)
{
    char found[16];
    int count = -1;
    if (fscanf(from, "%15s %d", found, &count) != 2 || strcmp(found, word) != 0 || count < 0 || count > 1000000) {
        fail(path, word);
    }
    return count;
}

static double *read_numbers(FILE *const from, const char *const path, const char *const word, int *const count)
{
    *count = read_count(from, path, word);
    double *const result = memory_for((size_t)*count, sizeof *result);
    for (int i = 0; i < *count; i++) {
        if (fscanf(from, "%lf", &result[i]) != 1) {
            fail(path, word);
        }
    }
    return result;
}

static labels read_labels(FILE *const from, const char *const path, const char *const word)
{
    labels result = {.count = read_count(from, path, word)};
    result.names = memory_for((size_t)result.count, sizeof *result.names);
    result.units = memory_for((size_t)result.count, sizeof *result.units);
    for (int i = 0; i < result.count; i++) {
        if (fscanf(from, " %79[^\t] %39[^\n]", result.names[i], result.units[i]) != 2) {
            fail(path, word);
        }
    }
    return result;
}

model model_read(const char *const path)
{
    model m = {0};
    int count;
    FILE *const from = fopen(path, "r");
    if (from == NULL) {
        fail(path, "it cannot be read");
    }
    m.x = read_numbers(from, path, "x", &m.states);
    m.u = read_numbers(from, path, "u", &m.held);
    m.p = read_numbers(from, path, "p", &m.parameters);
    m.n = read_labels(from, path, "states").count;
    m.inputs = read_labels(from, path, "inputs");
    m.outputs = read_labels(from, path, "outputs");
    m.up = read_numbers(from, path, "up", &count);
    m.down = read_numbers(from, path, "down", &count);
    m.a = read_numbers(from, path, "A", &count);
    m.b = read_numbers(from, path, "B", &count);
    m.c = read_numbers(from, path, "C", &count);
    m.d = read_numbers(from, path, "D", &count);
    m.rates = read_numbers(from, path, "rates", &count);
    const double *const modes = read_numbers(from, path, "modes", &count);
    m.slowest = modes[0];
    m.fastest = modes[1];
    m.growth = modes[2];
    fclose(from);
    return m;
}

/* The largest number of a matrix in rows and columns that have no pivot yet. */
static int next_pivot(const double complex *const m, const int n, const bool *const has_row, const int *const pivot)
{
    int found = -1;
    for (int i = 0; i < n * n; i++) {
        const bool is_free = !has_row[i / n] && pivot[i % n] < 0;
        found = is_free && (found < 0 || cabs(m[i]) > cabs(m[found])) ? i : found;
    }
    return found;
}

/* By Gauss and Jordan: at the end a column with a pivot has nothing else. */
void solve_complex(double complex *const m, const int n, double complex *const b)
{
    bool *const has_row = memory_for((size_t)n, sizeof *has_row);
    int *const pivot = memory_for((size_t)n, sizeof *pivot); /* of each column; -1: none */
    double complex *const x = memory_for((size_t)n, sizeof *x);
    double largest = 0.0;
    memset(pivot, -1, (size_t)n * sizeof *pivot);
    for (int at = next_pivot(m, n, has_row, pivot); at >= 0 && cabs(m[at]) > 1e-12 * largest;
         at = next_pivot(m, n, has_row, pivot)) {
        const int row = at / n, column = at % n;
        largest = fmax(largest, cabs(m[at]));
        has_row[row] = true;
        pivot[column] = at;
        for (int i = 0; i < n; i++) {
            const double complex factor = i == row ? 0.0 : m[i * n + column] / m[at];
            for (int j = 0; j < n; j++) {
                m[i * n + j] -= factor * m[row * n + j];
            }
            b[i] -= factor * b[row];
        }
    }
    for (int j = 0; j < n; j++) {
        x[j] = pivot[j] < 0 ? 0.0 : b[pivot[j] / n] / m[pivot[j]];
    }
    memcpy(b, x, (size_t)n * sizeof *b);
    free(has_row);
    free(pivot);
    free(x);
}

void response(const model *const m, const int input, const double w, double complex *const x)
{
    const int n = m->n;
    double complex *const left = memory_for((size_t)(n * n), sizeof *left);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            left[i * n + j] = -m->a[i * n + j] + (i == j ? w * (double complex)_Complex_I : 0.0);
        }
        x[i] = m->b[i * m->inputs.count + input];
    }
    solve_complex(left, n, x);
    free(left);
}

double complex gain(const model *const m, const int input, const int output, const double w)
{
    double complex *const x = memory_for((size_t)m->n, sizeof *x);
    double complex sum = m->d[output * m->inputs.count + input];
    response(m, input, w, x);
    for (int i = 0; i < m->n; i++) {
        sum += m->c[output * m->n + i] * x[i];
    }
    free(x);
    return sum;
}

bool is_steady(const model *const m)
{
    bool is = true;
    for (int i = 0; i < m->n; i++) {
        double scale = 1.0, by = 0.0;
        for (int k = 0; k < m->n; k++) {
            scale = fmax(scale, fabs(m->a[i * m->n + k]));
            by = fmax(by, fabs(m->a[k * m->n + i]));
        }
        is = is && (fabs(m->rates[i]) <= 1e-7 * scale || by <= 1e-12);
    }
    return is;
}
