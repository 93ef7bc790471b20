/* The compiler knows neither recipe nor n here: to unroll loops would take it most of its time, and changes no bit. */
#ifndef ISO_UNROLL
#define ISO_UNROLL
#endif

#include "tools/isoc/method/step_map.h"

#include <math.h>

#include "core/methods/all.h"
#include "core/methods/dense.h"
#include "core/methods/multirate.h"
#include "core/methods/primed.h"

/* The parameters: n, the numbers of positions and of fast states, J row by row, and which states are fast. */
enum { STATES, POSITIONS, FAST, JACOBIAN };

static double row_of(const double *p, const double *x, int row)
{
    const int n = (int)p[STATES];
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += p[JACOBIAN + row * n + i] * x[i];
    }
    return sum;
}

static void derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                       const double *restrict const p)
{
    (void)u;
    for (int i = 0; i < (int)p[STATES]; i++) {
        dx[i] = row_of(p, x, i);
    }
}

static void rates(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                  const double *restrict const p)
{
    (void)u;
    for (int i = 0; i < (int)p[POSITIONS]; i++) {
        dx[i] = row_of(p, x, i);
    }
}

static void fast_derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                            const double *restrict const p)
{
    const int n = (int)p[STATES];
    (void)u;
    for (int i = 0; i < (int)p[FAST]; i++) {
        dx[i] = row_of(p, x, (int)p[JACOBIAN + n * n + i]);
    }
}

/* The numbers of 1 - hb J: the number of states, hb, and the factors. */
enum { FACTORED_STATES, FACTORED_PART, FACTORS };

static void factor(double *restrict const lu, const double *restrict const x, const double *restrict const u,
                   const double *restrict const p, const double hb)
{
    const size_t n = (size_t)p[STATES];
    (void)x;
    (void)u;
    lu[FACTORED_STATES] = p[STATES];
    lu[FACTORED_PART] = hb;
    memcpy(lu + FACTORS, p + JACOBIAN, n * n * sizeof *lu);
    iso_dense_factor(lu + FACTORS, n, hb);
}

static void solve(double *restrict const d, const double *restrict const lu)
{
    iso_dense_solve(d, lu + FACTORS, (size_t)lu[FACTORED_STATES]);
}

static double *parameters_of(arena *memory, const linear_plant *l)
{
    const size_t n = (size_t)l->n;
    double *p = arena_take(memory, JACOBIAN + n * (n + 1), sizeof *p);
    p[STATES] = l->n;
    p[POSITIONS] = l->positions;
    memcpy(p + JACOBIAN, l->jacobian, n * n * sizeof *p);
    return p;
}

/* The unit vector of a column, or zero behind the last one; and back as this column. */
static void set_unit(double *x, size_t size, size_t column)
{
    for (size_t i = 0; i < size; i++) {
        x[i] = i == column;
    }
}

static void set_column(double *map, const double *x, size_t size, size_t column)
{
    for (size_t i = 0; i < size; i++) {
        map[i * size + column] = x[i];
    }
}

/* Nothing is an error for adams, so that it keeps to the step. */
static const iso_adams_options even = {.tolerance_absolute = (double)INFINITY, .budget = 1};

static iso_equations equations_of(const linear_plant *l)
{
    const size_t n = (size_t)l->n;
    return (iso_equations){.derivative = derivative,
                           .factor = factor,
                           .solve = solve,
                           .factors = n * n + FACTORS,
                           .rates = rates,
                           .positions = (size_t)l->positions,
                           .adams = &even};
}

double *step_map(arena *memory, unsigned recipe, const linear_plant *l, double step, int *size)
{
    enum { STARTING = 4 * ISO_ADAMS_ORDERS }; /* steps of adams from zero, after which its order is the highest */
    const size_t n = (size_t)l->n, kept = ISO_METHOD_STATE(recipe, n);
    const iso_equations equations = equations_of(l);
    const double *const p = parameters_of(memory, l);
    double *x = arena_take(memory, kept, sizeof *x), *lu = arena_take(memory, equations.factors, sizeof *lu);
    double *work = arena_take(memory, ISO_METHOD_WORK(recipe, n) + ISO_METHOD_PRIME_WORK(recipe, n), sizeof *work);
    double *map = arena_take(memory, kept * kept, sizeof *map);
    iso_any_progress started = {{.local_error = 0.0}};
    iso_method_prime(recipe, n, &equations, step, x, NULL, p, lu, work, &started.progress);
    for (size_t result = ISO_IS_VARYING(recipe) ? 0 : STARTING; result < STARTING + kept; result++) {
        iso_any_progress progress = started;
        const bool is_started = result >= STARTING;
        set_unit(x, kept, is_started ? result - STARTING : kept);
        iso_method_step(recipe, n, &equations, step, x, NULL, p, lu, work, &progress.progress);
        if (is_started) {
            set_column(map, x, kept, result - STARTING);
        } else {
            started = progress;
        }
    }
    *size = (int)kept;
    return map;
}

double implicit_part(arena *memory, unsigned recipe)
{
    static const double still = 0.0;
    const linear_plant resting = {&still, 1, 1};
    const iso_equations equations = equations_of(&resting);
    const double *p = parameters_of(memory, &resting);
    double *x = arena_take(memory, ISO_METHOD_STATE(recipe, 1), sizeof *x), lu[FACTORS + 1] = {0.0};
    double *work = arena_take(memory, ISO_METHOD_WORK(recipe, 1) + ISO_METHOD_PRIME_WORK(recipe, 1), sizeof *work);
    iso_any_progress progress = {{.local_error = 0.0}};
    iso_method_prime(recipe, 1, &equations, 1.0, x, NULL, p, lu, work, &progress.progress);
    lu[FACTORED_PART] = 0.0;
    iso_method_step(recipe, 1, &equations, 1.0, x, NULL, p, lu, work, &progress.progress);
    return lu[FACTORED_PART];
}

double *two_rates_map(arena *memory, unsigned recipe, const linear_plant *l, const bool *is_fast, int substeps,
                      double step)
{
    const size_t n = (size_t)l->n;
    const iso_equations equations = {.derivative = derivative};
    uint16_t *fast = arena_take(memory, n + 1, sizeof *fast), *slow = arena_take(memory, n + 1, sizeof *slow);
    double *p = parameters_of(memory, l), *x = arena_take(memory, n + 1, sizeof *x);
    double *map = arena_take(memory, n * n + 1, sizeof *map);
    iso_fast states = {
        .derivative = fast_derivative, .states = fast, .is_fast = is_fast, .reads = slow, .substeps = substeps};
    for (size_t i = 0; i < n; i++) {
        if (is_fast[i]) {
            p[JACOBIAN + n * n + states.count] = (double)i;
            fast[states.count++] = (uint16_t)i;
        } else {
            slow[states.read_count++] = (uint16_t)i;
        }
    }
    p[FAST] = (double)states.count;
    double *work = arena_take(memory, ISO_MULTIRATE_WORK(recipe, n, states.count, states.read_count), sizeof *work);
    for (size_t column = 0; column < n; column++) {
        set_unit(x, n, column);
        iso_multirate_step(ISO_METHOD_OF(recipe), n, &equations, &states, step, x, NULL, p, work);
        set_column(map, x, n, column);
    }
    return map;
}
