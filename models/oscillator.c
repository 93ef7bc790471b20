/* A mass on a spring with a damper, pushed by a force: a plant written by hand.
 *
 *     m x'' = F - c x' - k x,    F = 1 N for the first second, then 0
 */
#define ISO_HAS_JACOBIAN
#include "core/methods/dense.h"
#include "core/numbers/signal.h"
#include "core/runtime/handwritten.h"

enum { POSITION, SPEED, STATES };
enum { FORCE, INPUTS };
enum { MASS, DAMPING, STIFFNESS, PARAMETERS };
enum { OUT_POSITION, OUT_SPEED, OUT_ENERGY, OUTPUTS };

ISO_PLANT_MEMORY(STATES, INPUTS, PARAMETERS, OUTPUTS);

static const real start[STATES] = {[POSITION] = R(0.1)};
static const real defaults[PARAMETERS] = {[MASS] = R(0.5), [DAMPING] = R(0.4), [STIFFNESS] = R(80.0)};

static void derivative(real *restrict const dx, const real *restrict const x, const real *restrict const u,
                       const real *restrict const p)
{
    dx[POSITION] = x[SPEED];
    dx[SPEED] = (u[FORCE] - p[DAMPING] * x[SPEED] - p[STIFFNESS] * x[POSITION]) / p[MASS];
}

static void output(real *restrict const y, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p)
{
    (void)u;
    y[OUT_POSITION] = x[POSITION];
    y[OUT_SPEED] = x[SPEED];
    y[OUT_ENERGY] = R(0.5) * (p[MASS] * x[SPEED] * x[SPEED] + p[STIFFNESS] * x[POSITION] * x[POSITION]);
}

static void drive(void *const instance, const uint64_t tick)
{
    plant_memory *const memory = instance;
    const real t = iso_real_of_ticks(tick) * ISO_STEP_SIZE;
    memory->u[FORCE] = iso_select(iso_less(t, R(1.0)), R(1.0), R(0.0));
}

/* For implicit methods: 1 - hb J with J = [0 1; -k/m -c/m], factored and solved. */
static void factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                   const real *restrict const p, const real hb)
{
    (void)x;
    (void)u;
    lu[0] = R(0.0);
    lu[1] = R(1.0);
    lu[2] = -p[STIFFNESS] / p[MASS];
    lu[3] = -p[DAMPING] / p[MASS];
    iso_dense_factor(lu, STATES, hb);
}

static void solve(real *restrict const d, const real *restrict const lu)
{
    iso_dense_solve(d, lu, STATES);
}

static const iso_equations equations = {derivative, factor, solve, .factors = STATES * STATES};

ISO_PLANT(STATES, INPUTS, PARAMETERS, OUTPUTS, .name = "oscillator", .state_names = "position,speed",
          .output_names = "position,speed,energy", .output_units = "m,m/s,J", .defaults = defaults, .drive = drive);
