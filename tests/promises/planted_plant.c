/* A plant whose step or output depends on data in the way that PLANTED names: what poison.c must report. */
#define ISO_HAS_JACOBIAN
#include "core/methods/dense.h"
#include "core/runtime/handwritten.h"

enum { NOTHING, BRANCH, INDEX, LOOP, OUTPUT, MEMORY };

#ifndef PLANTED
#define PLANTED NOTHING
#endif

ISO_PLANT_MEMORY(1, 0, 1, 1);

static const real start[1] = {R(1.0)};
static const real defaults[1] = {R(2.0)};
static const real table[4] = {R(1.0), R(2.0), R(4.0), R(8.0)};
static volatile uint32_t positive;

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    dx[0] = -p[0] * x[0];
    if (PLANTED == BRANCH && x[0] > R(0.0)) {
        positive = 1;
    }
    if (PLANTED == INDEX) {
        dx[0] += table[iso_bits_of(x[0]) & 3];
    }
    for (uint32_t i = 0; PLANTED == LOOP && i < (iso_bits_of(x[0]) & 3); i++) {
        positive += 1;
    }
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    (void)p;
    y[0] = x[0];
    if (PLANTED == OUTPUT && x[0] > R(0.0)) {
        positive = 1;
    }
}

static void advance(void *const instance)
{
    const plant_memory *const memory = instance;
    if (PLANTED == MEMORY && memory->x[0] > R(0.0)) {
        positive = 1;
    }
}

static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    lu[0] = -p[0];
    iso_dense_factor(lu, 1, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, 1);
}

static const iso_equations equations = {derivative, factor, solve, .factors = 1};

ISO_PLANT(1, 0, 1, 1, .name = "planted", .advance = advance, .output_names = "x", .defaults = defaults);
