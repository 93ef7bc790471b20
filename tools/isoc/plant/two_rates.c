/* The kernel itself, which tools have in double, tells: it is run from each unit vector. */
#include "tools/isoc/plant/two_rates.h"

#include "core/methods/multirate.h"

/* Of u: J, row by row; of p: n, how many are fast, and which. */
static double row_of(const double *j, const double *x, int n, int row)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += j[row * n + i] * x[i];
    }
    return sum;
}

static void derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                       const double *restrict const p)
{
    for (int i = 0; i < (int)p[0]; i++) {
        dx[i] = row_of(u, x, (int)p[0], i);
    }
}

static void fast_derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                            const double *restrict const p)
{
    for (int i = 0; i < (int)p[1]; i++) {
        dx[i] = row_of(u, x, (int)p[0], (int)p[2 + i]);
    }
}

double *two_rates_map(arena *memory, const double *j, int n, const bool *is_fast, int substeps, unsigned recipe,
                      double step)
{
    const size_t states = (size_t)n;
    const iso_equations equations = {.derivative = derivative};
    uint16_t *fast = arena_take(memory, states + 1, sizeof *fast), *slow = arena_take(memory, states + 1, sizeof *slow);
    double *p = arena_take(memory, states + 2, sizeof *p), *x = arena_take(memory, states + 1, sizeof *x);
    double *map = arena_take(memory, states * states + 1, sizeof *map);
    iso_fast of = {
        .derivative = fast_derivative, .states = fast, .is_fast = is_fast, .reads = slow, .substeps = substeps};
    for (int i = 0; i < n; i++) {
        if (is_fast[i]) {
            p[2 + of.count] = i;
            fast[of.count++] = (uint16_t)i;
        } else {
            slow[of.read_count++] = (uint16_t)i;
        }
    }
    p[0] = n;
    p[1] = (double)of.count;
    double *work = arena_take(memory, ISO_MULTIRATE_WORK(ISO_RK4, states, of.count, of.read_count), sizeof *work);
    for (int column = 0; column < n; column++) {
        for (int i = 0; i < n; i++) {
            x[i] = i == column;
        }
        iso_multirate_step(recipe & ISO_METHOD_BITS, states, &equations, &of, step, x, j, p, work);
        for (int i = 0; i < n; i++) {
            map[i * n + column] = x[i];
        }
    }
    return map;
}
