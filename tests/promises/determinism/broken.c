/* A pendulum with a damper, by hand, broken in the way that BROKEN names: what the check meant for it must find. */
#include "core/numbers/sincos.h"
#include "core/runtime/handwritten.h"

#define NOTHING 0
#define FUSED 1
#define LIBM 2
#define BRANCH 3
#define UNINITIALISED 4
#define REASSOCIATED 5

#ifndef BROKEN
#define BROKEN NOTHING
#endif

/* Options for one function, which gcc alone has; inlined it would have those of its caller. */
#ifdef __clang__
#define OPTIONS(options)
#else
#define OPTIONS(options) __attribute__((noinline, optimize(options)))
#endif

enum { ANGLE, SPEED, STATES };

ISO_PLANT_MEMORY(STATES, 0, 1, 1);

static const real start[STATES] = {[ANGLE] = R(2.0)};
static const real defaults[1] = {R(0.05)}; /* of the damper */
static volatile uint32_t positive;

float sinf(float x);

/* -sin(angle) - damping speed */
#if BROKEN == FUSED
OPTIONS("fp-contract=fast")
#elif BROKEN == REASSOCIATED
OPTIONS("associative-math,no-signed-zeros,no-trapping-math")
#endif
static real acceleration(const real angle, const real speed, const real damping)
{
    const real sine = BROKEN == LIBM ? (real)sinf((float)angle) : iso_sincos(angle).sin;
    const real whole = (speed + ISO_ROUNDER) - ISO_ROUNDER;
    return (whole - speed) * damping - sine - whole * damping;
}

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    (void)u;
    dx[ANGLE] = x[SPEED];
    dx[SPEED] = acceleration(x[ANGLE], x[SPEED], p[0]);
    if (BROKEN == BRANCH && x[ANGLE] > R(0.0)) {
        positive++;
    }
    if (BROKEN == UNINITIALISED) {
        real room[2];
        const real *hidden = room;
        __asm__("" : "+r"(hidden));
        dx[SPEED] += iso_real_of(iso_bits_of(hidden[1]) & 1);
    }
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    (void)p;
    y[0] = x[ANGLE];
}

static const iso_equations equations = {derivative, NULL, NULL, .factors = 0};

ISO_PLANT(STATES, 0, 1, 1, .name = "broken", .output_names = "angle", .defaults = defaults);
