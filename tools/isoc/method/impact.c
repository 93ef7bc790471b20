#include "tools/isoc/method/impact.h"

#include <math.h>

/* As in step_map.c. */
#ifndef ISO_UNROLL
#define ISO_UNROLL
#endif

#include "core/methods/all.h"
#include "core/methods/dense.h"
#include "core/methods/primed.h"
#include "tools/isoc/base/numbers.h"

/* --- x' = v, v' = -k max(x, 0) --- */

enum { PLACE, PACE, WALL_STATES };

static void wall_derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                            const double *restrict const k)
{
    (void)u;
    dx[PLACE] = x[PACE];
    dx[PACE] = -k[0] * fmax(x[PLACE], 0.0);
}

static void wall_factor(double *restrict const lu, const double *restrict const x, const double *restrict const u,
                        const double *restrict const k, const double hb)
{
    (void)u;
    const double jacobian[] = {0.0, 1.0, x[PLACE] > 0.0 ? -k[0] : 0.0, 0.0};
    memcpy(lu, jacobian, sizeof jacobian);
    iso_dense_factor(lu, WALL_STATES, hb);
}

static void wall_solve(double *restrict const d, const double *restrict const lu)
{
    iso_dense_solve(d, lu, WALL_STATES);
}

/* Nothing is an error for adams, so that it keeps to the step. */
static const iso_adams_options unhurried = {.tolerance_absolute = (double)INFINITY, .budget = 1};

static const iso_equations wall = {wall_derivative, wall_factor, wall_solve, .factors = WALL_STATES * WALL_STATES,
                                   .adams = &unhurried};

/* The speed after an impact with a speed of one, by steps of one, of which `phase` of the last one before the contact
 * is left. Free steps stand before it, in which a history is primed, and behind it, in which it ends. */
static double speed_after(arena *memory, unsigned recipe, double frequency, double phase)
{
    enum { FREE = 8, MOST = 1000 };
    const double k = frequency * frequency;
    const size_t room = ISO_METHOD_WORK(recipe, WALL_STATES) + ISO_METHOD_PRIME_WORK(recipe, WALL_STATES);
    double *x = arena_take(memory, ISO_METHOD_STATE(recipe, WALL_STATES), sizeof *x);
    double *work = arena_take(memory, room, sizeof *work), lu[WALL_STATES * WALL_STATES];
    iso_any_progress progress = {{.local_error = 0.0}};
    x[PLACE] = -FREE - phase;
    x[PACE] = 1.0;
    iso_method_prime(recipe, WALL_STATES, &wall, 1.0, x, NULL, &k, lu, work, &progress.progress);
    for (int i = 0; i < MOST && x[PLACE] > -FREE - 1.0; i++) {
        iso_method_step(recipe, WALL_STATES, &wall, 1.0, x, NULL, &k, lu, work, &progress.progress);
    }
    return -x[PACE];
}

/* --- limits --- */

/* The phases at the begin of a contact; and as many frequencies, from the limit down to where a contact takes one step
 * more, so that at its end there are all phases too. */
enum { STEPS = 16, PHASES = 12 };

static const double pi = 3.14159265358979323846;

/* The lead that a recipe needs with a frequency at all phases: from the least to the most. A force k (x + lead v)
 * leaves exp(-pi w lead / 2) of the speed, but for its third order. */
static void leads_of(unsigned recipe, double frequency, double *least, double *most)
{
    arena *memory = arena_new();
    *least = HUGE_VAL;
    *most = 0.0;
    for (int i = 0; i < PHASES * PHASES; i++) {
        const double w = frequency * (1.0 - (i / PHASES + 0.5) / (PHASES * STEPS));
        const double left = speed_after(memory, recipe, w, (i % PHASES + 0.5) / PHASES);
        const double lead = 2.0 * elementary_log(left) / (pi * w);
        *least = fmin(*least, lead);
        *most = fmax(*most, lead);
    }
    arena_free(memory);
}

impact_limits impact_limits_of(unsigned recipe, double rate)
{
    /* For phases between these, and for the errors in the damping of an effect: tests/isoc/effects/test_impacts.py. */
    const double margin = 1.0 / 3.0, decimals = 1e4;
    const unsigned options = ISO_COMPENSATED | ISO_CHECKED | ISO_SMOOTH | ISO_SETTLED;
    const double frequency = fmin(pi / STEPS, rate / sqrt(2.0));
    double least, most;
    leads_of(recipe & ~options, frequency, &least, &most);
    return (impact_limits){frequency, ceil((most + margin * (most - least)) * decimals) / decimals};
}
