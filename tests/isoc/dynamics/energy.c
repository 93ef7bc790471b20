/* The account of energy of a plant, whose last outputs are energy, power and balance, along its run as its scene drives
 * it: energy KIND TICKS EVERY LOSSES. In double, by rk4. Before these outputs are as many losses of effects: none gives
 * energy.
 *
 * At a point the rate of the energy is the power: `balance` is zero to rounding, in the states of the run, and in the
 * same with other speeds, where closures are violated too.
 *
 * Over a tick the energy changes by the work. From the plant's state at the beginning of a tick the test integrates the
 * motion, with the power as one more state, in one step of rk4 and in four: what is left is of order h^4 over the
 * whole, so four steps leave 1/256 where the equations are `smooth`, and with `corners` in them, of stops and contacts,
 * 1/16 of what a corner leaves, h^2, on average over where in the step it lies: 1/4 of the sum over some tens of them.
 * Inputs and memories are constant in a tick.
 *
 * What the plant has at the end of its own step beyond one step of rk4 is the energy that the projection onto the
 * closures takes: it is printed.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/methods/rk4.h"
#include "core/runtime/tick.h"
#include "tests/host/report.h"
#include "tests/one_step.h"

enum { STATES_MAX = 128, ENERGY = -3, POWER, BALANCE };

/* As in tests/isoc/dynamics/compare.c: of sums of some hundred terms that flow both ways. */
#define ROUNDING (4096.0 * DBL_EPSILON)

/* Where closures are redundant, or singular, the augmented Lagrangian makes n / e of a rounding error, with n = 6
 * iterations and e the root of it (augmented.h): in multipliers that do no work, but for the violation of rates. */
#define ROUNDING_SINGULAR (6.0 * 1.5e-8)

/* And the multipliers have a peak that is shorter than a step: a step that meets it is off by so much of what flows. */
#define PEAK 1e-6

/* A few corners of a small part of what flows may lie anywhere in their ticks. */
#define CORNER 1e-9

static const iso_plant *const plant = &iso_the_plant;

/* Positive control: each acceleration is off by a part of its own, up to twice this. */
static double off = 0.0;

/* The sums over the ticks that are looked at, and what they are compared with. */
typedef struct account {
    double unbalanced; /* W: the most that a balance was */
    double flow;       /* W: the most that flowed, without signs */
    double part;       /* the most that a balance was of its own flow, at other speeds */
    double left[2];    /* J: energy - work, by one step and by four, without signs */
    double flowed;     /* J: without signs */
    double gained;     /* W: the most that was lost less than nothing */
    double projected;  /* J: without signs */
} account;

/* Outputs before those of the account. */
static int losses;

static double shown(const int which, const double *const x)
{
    memcpy(plant->x, x, plant->model->states * sizeof *x);
    plant->model->output(plant->memory);
    return plant->y[plant->model->outputs + which];
}

/* The speeds stand behind all else, and are half of the states or fewer. */
static int first_speed(void)
{
    return (plant->model->states + 1) / 2;
}

/* The plant's derivative, and behind its states the power. */
static void derivative(double *restrict const dx, const double *restrict const x, const double *restrict const u,
                       const double *restrict const p)
{
    const int states = plant->model->states;
    iso_the_derivative(dx, x, u, p);
    for (int i = first_speed(); i < states; i++) {
        dx[i] *= 1.0 + off * (i % 3);
    }
    dx[states] = shown(POWER, x);
}

/* The power that flows between all forms of energy: of each state its part of the energy's rate, without its sign. */
static double flow_of(const double *const x)
{
    enum { PART = 1000000 };
    const int states = plant->model->states;
    double dx[STATES_MAX], near[STATES_MAX], sum = 0.0;
    iso_the_derivative(dx, x, plant->u, plant->p);
    memcpy(near, x, (size_t)states * sizeof *near);
    for (int i = 0; i < states; i++) {
        const double by = fmax(1.0, fabs(x[i])) / PART;
        near[i] = x[i] + by;
        const double more = shown(ENERGY, near);
        near[i] = x[i] - by;
        sum += fabs((more - shown(ENERGY, near)) / (2.0 * by) * dx[i]);
        near[i] = x[i];
    }
    return sum;
}

/* The balance in a state, and in the same with other speeds. */
static void look(account *const a, const double *const x)
{
    const int states = plant->model->states;
    double other[STATES_MAX];
    const double flow = flow_of(x);
    a->unbalanced = fmax(a->unbalanced, fabs(shown(BALANCE, x)));
    for (int i = 1; i <= losses; i++) {
        a->gained = fmax(a->gained, -plant->y[plant->model->outputs + ENERGY - i]);
    }
    a->flowed += flow * plant->model->step_size;
    memcpy(other, x, (size_t)states * sizeof *other);
    for (int i = first_speed(); i < states; i++) {
        other[i] += (fabs(other[i]) + 1.0) * (rand() / (RAND_MAX + 1.0) - 0.5);
    }
    const double other_flow = flow_of(other);
    a->flow = fmax(a->flow, fmax(flow, other_flow));
    a->part = fmax(a->part, fabs(shown(BALANCE, other)) / other_flow);
}

/* Moves x over a tick, in so many steps: what is left of the energy less the work. */
static double pass(double *const x, const int steps)
{
    const size_t states = plant->model->states;
    double moved[STATES_MAX + 1], work[ISO_EXPLICIT_VECTORS * (STATES_MAX + 1)];
    const iso_history history = {.n = states + 1, .x = moved};
    const double before = shown(ENERGY, x);
    memcpy(moved, x, states * sizeof *x);
    moved[states] = 0.0;
    for (int i = 0; i < steps; i++) {
        (void)one_explicit_step(&iso_tableau_rk4, &history, derivative, plant->model->step_size / steps, plant->u,
                                plant->p, work);
    }
    memcpy(x, moved, states * sizeof *x);
    return shown(ENERGY, moved) - before - moved[states];
}

/* What is left over the tick that comes; then the plant makes it. False where the guard stops it. */
static bool account_tick(account *const a, const uint64_t tick, void *const kept)
{
    const size_t bytes = plant->model->states * sizeof(double);
    double x[STATES_MAX], once[STATES_MAX], four[STATES_MAX];
    iso_plant_drive(plant, tick);
    memcpy(kept, plant->memory, plant->model->memory_bytes);
    memcpy(x, plant->x, bytes);
    memcpy(once, x, bytes);
    memcpy(four, x, bytes);
    look(a, x);
    a->left[0] += fabs(pass(once, 1));
    a->left[1] += fabs(pass(four, 4));
    memcpy(plant->memory, kept, plant->model->memory_bytes);
    plant->model->step(plant->memory);
    memcpy(x, plant->x, bytes);
    memcpy(plant->memory, kept, plant->model->memory_bytes);
    a->projected += fabs(shown(ENERGY, x) - shown(ENERGY, once));
    memcpy(plant->memory, kept, plant->model->memory_bytes);
    return iso_plant_tick(plant, tick) == plant->model->states;
}

static account run(const uint64_t ticks, const uint64_t every)
{
    account a = {0};
    void *const kept = malloc(plant->model->memory_bytes);
    if (kept == NULL) {
        abort();
    }
    bool well = true;
    srand(1);
    iso_plant_start(plant);
    for (uint64_t tick = 0; tick < ticks && well; tick++) {
        well = tick % every == 0 ? account_tick(&a, tick, kept) : iso_plant_tick(plant, tick) == plant->model->states;
    }
    free(kept);
    if (!well) {
        report_ok(false, "the guard has stopped it");
    }
    return a;
}

int main(int argc, char **argv)
{
    const bool is_smooth = argc > 1 && strcmp(argv[1], "smooth") == 0;
    const bool is_singular = argc > 1 && strcmp(argv[1], "singular") == 0;
    const double rounding = is_singular ? ROUNDING_SINGULAR : ROUNDING;
    const uint64_t ticks = argc > 2 ? strtoul(argv[2], NULL, 10) : 0, every = argc > 3 ? strtoul(argv[3], NULL, 10) : 1;
    losses = argc > 4 ? (int)strtol(argv[4], NULL, 10) : 0;
    const account a = run(ticks, every);
    report_ok(a.unbalanced <= ROUNDING * a.flow, "balance: %.1e W of %.2g W", a.unbalanced, a.flow);
    report_ok(a.gained <= ROUNDING * a.flow, "%d losses give no energy: at most %.1e W", losses, a.gained);
    report_ok(a.part <= rounding, "balance at other speeds: %.1e of what flows", a.part);
    const double limit = a.left[0] / (is_smooth ? 128.0 : 4.0);
    const double least = is_smooth ? ROUNDING : is_singular ? PEAK : CORNER;
    report_ok(a.left[1] <= fmax(limit, least * a.flowed),
              "energy - work in four steps: %.1e J, in one %.1e J, of %.2g J", a.left[1], a.left[0], a.flowed);
    report_note("projected %.3e J of %.3g J", a.projected, a.flowed);
    off = 1e-2;
    const account wrong = run(ticks, 16 * every);
    report_ok(wrong.left[1] / wrong.flowed > 2.0 * a.left[1] / a.flowed || a.flowed < DBL_EPSILON,
              "control: accelerations off by 1e-2 are seen: %.1e J of %.2g J", wrong.left[1], wrong.flowed);
    return report_done();
}
