/* Plants of random mechanisms, in double: accelerations, reactions and power against the independent dynamics, the
 * Jacobian against differences of the derivative, and the order of rk4, bdf4 and rosenbrock. */
#include <string.h>

#include "tests/general.h"
#include "tests/host/report.h"
#include "tests/isoc/dynamics/family.h"
#include "tests/isoc/dynamics/generate.h"
#include "tests/isoc/dynamics/random.h"

enum {
    STATES_MAX = 40,
    FACTORS_MAX = 4096,
    NUMBERS_MAX = 6 * (BODIES_MAX + CLOSURES_MAX) + COUPLINGS_MAX,
    VECTORS_MAX = 10,
};

/* Reactions and accelerations, relative to the largest of them. */
#define SOLVED_TOLERANCE 1e-10
/* Differences of order four over 2^-11 of a motion that changes by some 10 / s, and rounding over them. */
#define JACOBIAN_TOLERANCE 1e-7
#define ORDER_TOLERANCE 0.15

/* A motion lasts 1 s, or half, a quarter, ... of it: until rk4 follows it within SMOOTH in 2^COARSEST steps. */
#define SMOOTH 1e-5
enum { COARSEST = 4, FINEST = 10, REFERENCE = 11, SHORTEST = 6 };

typedef struct subject {
    const family_member *of;
    generated made;
    iso_plant plant;
    size_t n;
    const real *p, *held; /* parameters, and what the equations read of them */
    real u[GENERATED_INPUTS];
    real lasts; /* s */
} subject;

typedef struct states {
    real x[STATES_MAX];
} states;

/* --- accelerations and reactions --- */

/* The motion of a state x, whose speeds are its last numbers: with the clocks of motions before them. */
static joint_motion motion_of(const subject *const s, const real *const x)
{
    const mechanism *const m = &s->made.mechanism;
    joint_motion motion = {{{0.0L}}, {{0.0L}}, {{0.0L}}};
    const real *position = x;
    const real *speed = x + s->n - (size_t)mechanism_dofs(m);
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
            motion.q[j][k] = (wide)*position++;
        }
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            motion.v[j][k] = (wide)*speed++;
        }
    }
    return motion;
}

/* In the order of the scene's outputs, of which the last are power and balance. */
static int reactions_of(const mechanism *const m, const solution *const exact, wide *const y)
{
    int count = 0;
    for (int n = 0; n < m->bodies + m->closures; n++) {
        const reaction *const r = n < m->bodies ? &exact->joint[n] : &exact->closure[n - m->bodies];
        memcpy(y + count, r->force, sizeof r->force);
        memcpy(y + count + 3, r->moment, sizeof r->moment);
        count += 6;
    }
    for (int n = 0; n < m->couplings; n++) {
        y[count++] = exact->coupling[n];
    }
    return count;
}

typedef struct solved {
    double accelerations, reactions; /* how far off, relative to the largest number */
    double power;                    /* relative to the power that flows into the bodies' kinetic energies */
} solved;

static double relative(const wide *const want, const wide *const got, const int count)
{
    wide off = 0.0L;
    wide size = 0.0L;
    for (int i = 0; i < count; i++) {
        off = fmaxl(off, fabsl(got[i] - want[i]));
        size = fmaxl(size, fabsl(want[i]));
    }
    return (double)(off / size);
}

/* How far the power is off the rate of the independent energy, and the balance off zero. */
static double power_off(const mechanism *const m, const joint_motion *const motion, const iso_plant *const plant)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    const wide rate = mechanism_energy(m, motion, moved).c[1];
    const real *const last = plant->y + plant->model->outputs;
    wide size = fabsl(rate);
    for (int i = 0; i < m->bodies; i++) {
        for (int c = 0; c < 3; c++) {
            size += m->body[i].mass * fabsl(jet_mul(moved[i].velocity.x[c], moved[i].velocity.x[c]).c[1]);
        }
    }
    return (double)(fmaxl(fabsl((wide)last[-2] - rate), fabsl((wide)last[-1])) / size);
}

/* At state x and time t; the last mass of the independent dynamics times `heavier`, and in its energy the
 * accelerations. */
static solved solved_at(const subject *const s, const real *const x, const wide t, const wide heavier)
{
    mechanism m = s->made.mechanism;
    solution exact;
    real dx[STATES_MAX];
    wide want[NUMBERS_MAX], got[NUMBERS_MAX];
    joint_motion motion = motion_of(s, x);
    m.time = t;
    m.body[m.bodies - 1].mass *= heavier;
    if (!mechanism_solve(&m, &motion, s->made.input, &exact)) {
        return (solved){HUGE_VAL, HUGE_VAL, HUGE_VAL};
    }
    memcpy(s->plant.x, x, s->n * sizeof *x);
    s->plant.model->output(s->plant.memory);
    const int numbers = reactions_of(&m, &exact, want);
    for (int i = 0; i < numbers; i++) {
        got[i] = (wide)s->plant.y[i];
    }
    solved off = {.reactions = numbers + 2 == s->plant.model->outputs ? relative(want, got, numbers) : HUGE_VAL};
    s->of->equations->derivative(dx, x, s->u, s->held);
    const int dofs = mechanism_dofs(&m);
    int at = 0;
    for (int j = 0; j < m.bodies; j++) {
        for (int k = 0; k < joint_speeds(m.joint[j].kind); k++, at++) {
            want[at] = exact.a[j][k];
            got[at] = (wide)dx[s->n - (size_t)dofs + (size_t)at];
        }
    }
    off.accelerations = relative(want, got, dofs);
    for (int j = 0; j < m.bodies; j++) {
        for (int k = 0; k < SPEEDS_MAX; k++) {
            motion.a[j][k] = heavier * exact.a[j][k];
        }
    }
    off.power = power_off(&m, &motion, &s->plant);
    return off;
}

/* --- the Jacobian --- */

/* What (1 - hb J) d is for the solution d of (1 - hb J) d = r, less r: J d by differences of order four along d. */
static double jacobian_off(const subject *const s, const real *const x, const real scale)
{
    enum { SIDES = 4, TRIED = 3 };
    static const double steps[SIDES] = {-2.0, -1.0, 1.0, 2.0}, weights[SIDES] = {1.0, -8.0, 8.0, -1.0};
    static real lu[FACTORS_MAX];
    const real hb = R(0x1p-6), e = R(0x1p-11);
    sequence random = {UINT64_C(0x9E3779B97F4A7C15)};
    double worst = 0.0;
    s->of->equations->factor(lu, x, s->u, s->held, hb * scale);
    for (int n = 0; n < TRIED; n++) {
        real right[STATES_MAX] = {0.0}, d[STATES_MAX], at[STATES_MAX], f[STATES_MAX], product[STATES_MAX] = {0.0};
        double longest = 1.0;
        for (size_t i = 0; i < s->n; i++) {
            right[i] = d[i] = (real)sequence_next(&random, 1.0);
        }
        s->of->equations->solve(d, lu);
        for (size_t i = 0; i < s->n; i++) {
            longest = fmax(longest, fabs((double)d[i]));
        }
        for (int side = 0; side < SIDES; side++) {
            for (size_t i = 0; i < s->n; i++) {
                at[i] = x[i] + e / (real)longest * (real)steps[side] * d[i];
            }
            s->of->equations->derivative(f, at, s->u, s->held);
            for (size_t i = 0; i < s->n; i++) {
                product[i] += (real)(weights[side] * longest) * f[i] / (R(12.0) * e);
            }
        }
        for (size_t i = 0; i < s->n; i++) {
            worst = fmax(worst, fabs((double)(d[i] - hb * product[i] - right[i])) / longest);
        }
    }
    return worst;
}

/* --- orders --- */

static real jacobian_scale = R(1.0);
static const iso_equations *unscaled;

static void scaled_factor(real *restrict const lu, const real *restrict const x, const real *restrict const u,
                          const real *restrict const p, const real hb)
{
    unscaled->factor(lu, x, u, p, jacobian_scale * hb);
}

/* The state at the end of the motion in 2^k steps. */
static states run(const subject *const s, const unsigned recipe, const int k)
{
    real x[VECTORS_MAX * STATES_MAX] = {0.0}, work[ISO_PRIME_VECTORS * STATES_MAX];
    static real lu[FACTORS_MAX];
    const real h = s->lasts / (real)(1L << k);
    iso_any_progress progress = {{.local_error = R(0.0)}};
    iso_equations eq = *s->of->equations;
    states end = {{0.0}};
    unscaled = s->of->equations;
    eq.factor = scaled_factor;
    eq.linearise = NULL;
    memcpy(x, s->plant.model->start, s->n * sizeof *x);
    general_prime(recipe, s->n, &eq, h, x, s->u, s->held, lu, work, &progress.progress);
    for (long step = 0; step < 1L << k; step++) {
        general_step(recipe, s->n, &eq, h, x, s->u, s->held, lu, work, &progress.progress);
        if (s->of->settle != NULL) {
            s->of->settle(x, s->p);
        }
    }
    memcpy(end.x, x, s->n * sizeof *x);
    return end;
}

static double distance(const subject *const s, const states *const a, const states *const b)
{
    double square = 0.0;
    for (size_t i = 0; i < s->n; i++) {
        square += (double)((a->x[i] - b->x[i]) * (a->x[i] - b->x[i]));
    }
    return sqrt(square);
}

static void choose_length(subject *const s)
{
    s->lasts = R(1.0);
    for (int i = 0; i < SHORTEST; i++) {
        const states coarse = run(s, ISO_RK4, COARSEST), fine = run(s, ISO_RK4, COARSEST + 1);
        s->lasts *= distance(s, &coarse, &fine) <= SMOOTH ? R(1.0) : R(0.5);
    }
}

/* rk4 with the finest steps, and the error that half of them show taken off. */
static states reference(const subject *const s)
{
    states fine = run(s, ISO_RK4 | ISO_COMPENSATED, REFERENCE);
    const states coarse = run(s, ISO_RK4 | ISO_COMPENSATED, REFERENCE - 1);
    for (size_t i = 0; i < s->n; i++) {
        fine.x[i] += (fine.x[i] - coarse.x[i]) / R(15.0);
    }
    return fine;
}

static double error_of(const subject *const s, const states *const exact, const unsigned recipe, const int k)
{
    const states end = run(s, recipe, k);
    return distance(s, &end, exact);
}

/* The order that halved steps show, two times in a row as it should be; or else the last one. */
static double order_of(const subject *const s, const states *const exact, const unsigned recipe)
{
    double coarse = error_of(s, exact, recipe, COARSEST), order = 0.0;
    int held = 0;
    for (int k = COARSEST + 1; k <= FINEST && held < 2 && coarse > 1e-12; k++) {
        const double fine = error_of(s, exact, recipe, k);
        order = log2(coarse / fine);
        held = fabs(order - ISO_ORDER_OF(recipe)) <= ORDER_TOLERANCE ? held + 1 : 0;
        coarse = fine;
    }
    return held == 2 ? order : -order;
}

/* --- all --- */

static bool begin(const family_member *const of, subject *const s)
{
    s->of = of;
    s->plant = of->plant();
    s->n = s->plant.model->states;
    s->p = s->plant.p;
    if (!generate(of->closed, of->seed, &s->made) || s->n > STATES_MAX || of->equations->factors > FACTORS_MAX ||
        s->plant.model->inputs != s->made.inputs) {
        return report_ok(false, "%s: the plant has the states and inputs of its seed", of->name);
    }
    iso_plant_start(&s->plant);
    for (int i = 0; i < s->made.inputs; i++) {
        s->u[i] = s->plant.u[i] = (real)s->made.input[i];
    }
    s->held = of->held() == NULL ? s->p : of->held();
    choose_length(s);
    return true;
}

static void test_member(subject *const s)
{
    static const unsigned methods[] = {ISO_RK4, ISO_BDF4, ISO_ROSENBROCK};
    const char *const name = s->of->name;
    const real *const start = s->plant.model->start;
    const states end = reference(s);
    const solved first = solved_at(s, start, 0.0L, 1.0L), last = solved_at(s, end.x, (wide)s->lasts, 1.0L);
    report_ok(fmax(first.accelerations, first.reactions) <= SOLVED_TOLERANCE &&
                  fmax(last.accelerations, last.reactions) <= SOLVED_TOLERANCE,
              "%s: accelerations %.1e, after %g s %.1e, reactions %.1e and %.1e, at most %.0e", name,
              first.accelerations, (double)s->lasts, last.accelerations, first.reactions, last.reactions,
              SOLVED_TOLERANCE);
    report_ok(fmax(first.power, last.power) <= SOLVED_TOLERANCE, "%s: power and balance %.1e and %.1e, at most %.0e",
              name, first.power, last.power, SOLVED_TOLERANCE);
    const double off = fmax(jacobian_off(s, start, R(1.0)), jacobian_off(s, end.x, R(1.0)));
    report_ok(off <= JACOBIAN_TOLERANCE, "%s: what the Jacobian solves is off by %.1e, at most %.0e", name, off,
              JACOBIAN_TOLERANCE);
    double order[3];
    bool held = true;
    for (int i = 0; i < 3; i++) {
        order[i] = order_of(s, &end, methods[i]);
        held = held && order[i] > 0.0;
    }
    report_ok(held, "%s: orders %.2f of rk4, %.2f of bdf4, %.2f of rosenbrock, within %.2f twice", name, order[0],
              order[1], order[2], ORDER_TOLERANCE);
}

/* Errors that were planted, and are found in one member at least: not in each, as a body may move alone, which no joint
 * feels. */
typedef struct controls {
    bool mass, jacobian, order;
} controls;

static void try_controls(subject *const s, controls *const found)
{
    const real *const start = s->plant.model->start;
    if (!found->mass) {
        const solved off = solved_at(s, start, 0.0L, 1.0L + 1e-6L);
        found->mass = fmin(off.power, fmin(off.accelerations, off.reactions)) > SOLVED_TOLERANCE;
    }
    found->jacobian = found->jacobian || jacobian_off(s, start, R(1.0001)) > JACOBIAN_TOLERANCE;
    if (!found->order) {
        const states end = reference(s);
        jacobian_scale = R(1.02);
        found->order = order_of(s, &end, ISO_ROSENBROCK) < 0.0;
        jacobian_scale = R(1.0);
    }
}

int main(void)
{
    static subject s;
    controls found = {0};
    for (int i = 0; family[i] != NULL; i++) {
        if (begin(family[i], &s)) {
            test_member(&s);
            try_controls(&s, &found);
        }
    }
    report_ok(found.mass, "control: a mass off by 1e-6 is off in accelerations, reactions and power");
    report_ok(found.jacobian, "control: a Jacobian off by 1e-4 solves another equation");
    report_ok(found.order, "control: a Jacobian off by 2 %% takes rosenbrock its order");
    return report_done();
}
