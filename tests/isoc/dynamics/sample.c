#include "tests/isoc/dynamics/sample.h"

#include <string.h>

#include "tests/isoc/dynamics/random.h"

enum { TRIES = 10 * STATES, PERTURBATIONS = 4 };

#define PI 3.14159265358979
#define PERTURBED 1e-10L

/* What rounding changes in speeds that satisfy closures, of a condition of some hundred. */
#define ROUNDED (1000.0L * (wide)ISO_REAL_EPSILON)

/* A state of a larger condition is drawn anew. */
#define CONDITION_MAX 1000.0L

static bool is_quaternion(const joint_kind kind, const int coordinate)
{
    return kind == SPHERICAL || (kind == FREE && coordinate >= 3);
}

static bool slides(const joint_kind kind, const int coordinate)
{
    return kind == PRISMATIC || (kind == CYLINDRICAL && coordinate < 1) || (kind == PLANAR && coordinate < 2) ||
           (kind == FREE && coordinate < 3);
}

/* The motion of a state x, with accelerations of dx. */
static joint_motion motion_of(const real *const x, const real *const dx)
{
    const mechanism *const m = &the_table.mechanism;
    joint_motion motion = {{{0.0L}}, {{0.0L}}, {{0.0L}}};
    const real *position = x;
    const real *speed = x + mechanism_coordinates(m);
    const real *acceleration = dx + mechanism_coordinates(m);
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
            motion.q[j][k] = (wide)*position++;
        }
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            motion.v[j][k] = (wide)*speed++;
            motion.a[j][k] = (wide)*acceleration++;
        }
    }
    return motion;
}

static void state_of(const joint_motion *const motion, real *x)
{
    const mechanism *const m = &the_table.mechanism;
    real *speed = x + mechanism_coordinates(m);
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
            *x++ = (real)motion->q[j][k];
        }
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            *speed++ = (real)motion->v[j][k];
        }
    }
}

static void normalise_quaternions(joint_motion *const motion)
{
    const mechanism *const m = &the_table.mechanism;
    for (int j = 0; j < m->bodies; j++) {
        wide square = 0.0L;
        for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
            square += is_quaternion(m->joint[j].kind, k) ? motion->q[j][k] * motion->q[j][k] : 0.0L;
        }
        for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
            motion->q[j][k] /= is_quaternion(m->joint[j].kind, k) ? sqrtl(square) : 1.0L;
        }
    }
}

static joint_motion draw_motion(sequence *const random)
{
    const mechanism *const m = &the_table.mechanism;
    const real none[STATES_MAX] = {R(0.0)};
    const bool closed = m->closures > 0;
    joint_motion motion = motion_of(closed ? iso_the_plant.model->start : none, none);
    for (int j = 0; j < m->bodies; j++) {
        const joint_kind kind = m->joint[j].kind;
        for (int k = 0; k < joint_coordinates(kind); k++) {
            const double turn = closed ? the_table.spread : is_quaternion(kind, k) ? 1.0 : PI;
            const double slide = closed ? the_table.spread / 10.0 : 0.5;
            motion.q[j][k] += (wide)sequence_next(random, slides(kind, k) ? slide : turn);
        }
        for (int k = 0; k < joint_speeds(kind); k++) {
            motion.v[j][k] = (wide)sequence_next(random, 10.0);
        }
    }
    normalise_quaternions(&motion);
    return motion;
}

/* A number times 1 + as much as PERTURBED, at random. */
static void perturb(sequence *const random, wide *const number, const int count)
{
    for (int i = 0; i < count; i++) {
        number[i] *= 1.0L + PERTURBED * (wide)sequence_next(random, 1.0);
    }
}

/* The mechanism with every mass, moment of inertia and length a little off. */
static mechanism perturbed(sequence *const random)
{
    mechanism m = the_table.mechanism;
    for (int i = 0; i < m.bodies; i++) {
        perturb(random, &m.body[i].mass, 1);
        perturb(random, m.body[i].com, 3);
        perturb(random, m.body[i].inertia, 6);
        perturb(random, m.joint[i].on_parent.at, 3);
        perturb(random, m.joint[i].on_child.at, 3);
    }
    for (int n = 0; n < m.closures; n++) {
        perturb(random, m.closure[n].on_parent.at, 3);
        perturb(random, m.closure[n].on_child.at, 3);
    }
    return m;
}

/* The most that the accelerations change in some directions. False if the closures cannot be kept. */
static bool find_condition(sample *const s, sequence *const random)
{
    for (int n = 0; n < PERTURBATIONS; n++) {
        const mechanism m = perturbed(random);
        joint_motion off = s->motion;
        solution moved;
        wide change = 0.0L;
        wide size = 0.0L;
        for (int j = 0; j < m.bodies; j++) {
            perturb(random, off.q[j], joint_coordinates(m.joint[j].kind));
            perturb(random, off.v[j], joint_speeds(m.joint[j].kind));
        }
        if (!mechanism_close(the_table.overconstrained ? &the_table.mechanism : &m, &off) ||
            !mechanism_solve(&m, &off, s->input, &moved)) {
            return false;
        }
        for (int j = 0; j < m.bodies; j++) {
            for (int k = 0; k < joint_speeds(m.joint[j].kind); k++) {
                const wide e = (moved.a[j][k] - s->exact.a[j][k]) / PERTURBED;
                s->change[j][k] = fmaxl(s->change[j][k], fabsl(e));
                change += e * e;
                size += s->exact.a[j][k] * s->exact.a[j][k];
            }
        }
        s->condition = fmaxl(s->condition, sqrtl(change / size));
    }
    return s->condition <= CONDITION_MAX;
}

/* Whether closing left the speeds nearly as they are in x: else the rank of the closures is in doubt. */
static bool keeps_speeds(const joint_motion *const motion, const real *const x)
{
    const mechanism *const m = &the_table.mechanism;
    const joint_motion before = motion_of(x, x);
    wide change = 0.0L;
    wide size = 0.0L;
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            const wide e = motion->v[j][k] - before.v[j][k];
            change += e * e;
            size += motion->v[j][k] * motion->v[j][k];
        }
    }
    return change <= ROUNDED * ROUNDED * size;
}

/* False if the state does not close, or is too near to where the closures lose rank. */
static bool draw(sequence *const random, sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    joint_motion motion = draw_motion(random);
    if (!mechanism_close(m, &motion)) {
        return false;
    }
    memset(s, 0, sizeof *s);
    state_of(&motion, s->x);
    for (int i = 0; i < the_table.inputs; i++) {
        s->u[i] = (real)sequence_next(random, 10.0);
        s->input[i] = (wide)s->u[i];
    }
    iso_the_derivative(s->dx, s->x, s->u, iso_the_plant.model->defaults);
    s->motion = motion_of(s->x, s->dx);
    s->condition = 1.0L;
    return mechanism_close(m, &s->motion) && keeps_speeds(&s->motion, s->x) &&
           mechanism_solve(m, &s->motion, s->input, &s->exact) && (m->closures == 0 || find_condition(s, random));
}

bool sample_all(sample s[STATES])
{
    sequence random = {UINT64_C(0x9E3779B97F4A7C15)};
    int found = 0;
    for (int tries = 0; found < STATES && tries < TRIES; tries++) {
        found += draw(&random, &s[found]) ? 1 : 0;
    }
    return found == STATES;
}

wide sample_position_rates(const sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    const real *rate = s->dx;
    const real *speed = s->x + mechanism_coordinates(m);
    wide worst = 0.0L;
    for (int j = 0; j < m->bodies; j++) {
        const joint_kind kind = m->joint[j].kind;
        const int plain = kind == SPHERICAL ? 0 : kind == FREE ? 3 : joint_speeds(kind);
        for (int k = 0; k < plain; k++) {
            worst = memcmp(rate++, speed + k, sizeof *rate) == 0 ? worst : HUGE_VALL;
        }
        if (kind == SPHERICAL || kind == FREE) {
            /* q' = q (0, omega) / 2. */
            const wide *const q = s->motion.q[j] + plain;
            const wide v[3] = {(wide)speed[plain], (wide)speed[plain + 1], (wide)speed[plain + 2]};
            const wide product[4] = {
                -q[1] * v[0] - q[2] * v[1] - q[3] * v[2],
                q[0] * v[0] + q[2] * v[2] - q[3] * v[1],
                q[0] * v[1] + q[3] * v[0] - q[1] * v[2],
                q[0] * v[2] + q[1] * v[1] - q[2] * v[0],
            };
            const wide size = sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            for (int k = 0; k < 4; k++) {
                worst = fmaxl(worst, fabsl((wide)*rate++ - product[k] / 2.0L) / size);
            }
        }
        speed += joint_speeds(kind);
    }
    return worst;
}

void sample_outputs(const sample *const s, real *const y)
{
    const iso_model *const model = iso_the_plant.model;
    iso_plant_start(&iso_the_plant);
    memcpy(iso_the_plant.x, s->x, model->states * sizeof *s->x);
    if (model->inputs > 0) {
        memcpy(iso_the_plant.u, s->u, model->inputs * sizeof *s->u);
    }
    model->output(iso_the_plant.memory);
    memcpy(y, iso_the_plant.y, model->outputs * sizeof *y);
}
