/* A plant whose step or output depends on data in the way that PLANTED names: what poison.c must report. */
#include "core/choice.h"
#include "core/dense.h"

enum { NOTHING, BRANCH, INDEX, LOOP, OUTPUT };

#ifndef PLANTED
#define PLANTED NOTHING
#endif

static struct {
    real x[ISO_METHOD_STATE(ISO_METHOD, 1)];
    real p[1];
    real y[1];
    iso_progress progress;
} memory;

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

static void prime(void)
{
    real work[ISO_METHOD_PRIME_WORK(ISO_METHOD, 1)];
    iso_method_prime(ISO_METHOD, 1, &equations, ISO_STEP_SIZE, memory.x, NULL, memory.p, work, &memory.progress);
}

static void step(void)
{
    real work[ISO_METHOD_WORK(ISO_METHOD, 1)], lu[1];
    iso_method_step(ISO_METHOD, 1, &equations, ISO_STEP_SIZE, memory.x, NULL, memory.p, lu, work, &memory.progress);
}

const iso_plant iso_the_plant = {
    .name = "planted",
    .method = ISO_METHOD_TEXT,
    .step_text = ISO_STEP_TEXT,
    .step_size = ISO_STEP_SIZE,
    .period_ns = ISO_STEP_NS,
    .states = 1,
    .outputs = 1,
    .parameters = 1,
    .output_names = "x",
    .x = memory.x,
    .p = memory.p,
    .y = memory.y,
    .start = start,
    .defaults = defaults,
    .progress = &memory.progress,
    .memory = &memory,
    .memory_bytes = sizeof memory,
    .derivative = derivative,
    .output = output,
    .prime = prime,
    .step = step,
};
