#include "tests/dynamics/sample.h"

#include <string.h>

#include "tests/dynamics/random.h"

enum { TRIES = 100, PERTURBATIONS = 4 };

#define PI 3.14159265358979
#define PERTURBED 1e-9L

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
    joint_motion motion = motion_of(closed ? iso_the_plant.start : none, none);
    for (int j = 0; j < m->bodies; j++) {
        const joint_kind kind = m->joint[j].kind;
        for (int k = 0; k < joint_coordinates(kind); k++) {
            const double turn = is_quaternion(kind, k) || closed ? 1.0 : PI;
            motion.q[j][k] += (wide)sequence_next(random, slides(kind, k) ? closed ? 0.1 : 0.5 : turn);
        }
        for (int k = 0; k < joint_speeds(kind); k++) {
            motion.v[j][k] = (wide)sequence_next(random, 10.0);
        }
    }
    normalise_quaternions(&motion);
    return motion;
}

/* The most that the accelerations change over what the coordinates and speeds do, both relative, in some directions. */
static wide condition_of(const sample *const s, sequence *const random)
{
    const mechanism *const m = &the_table.mechanism;
    wide worst = 1.0L;
    for (int n = 0; n < PERTURBATIONS; n++) {
        joint_motion off = s->motion;
        solution moved;
        wide change = 0.0L;
        wide size = 0.0L;
        for (int j = 0; j < m->bodies; j++) {
            for (int k = 0; k < joint_coordinates(m->joint[j].kind); k++) {
                off.q[j][k] *= 1.0L + PERTURBED * (wide)sequence_next(random, 1.0);
            }
            for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
                off.v[j][k] *= 1.0L + PERTURBED * (wide)sequence_next(random, 1.0);
            }
        }
        if (!mechanism_close(m, &off) || !mechanism_solve(m, &off, s->input, &moved)) {
            return HUGE_VALL;
        }
        for (int j = 0; j < m->bodies; j++) {
            for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
                const wide e = moved.a[j][k] - s->exact.a[j][k];
                change += e * e;
                size += s->exact.a[j][k] * s->exact.a[j][k];
            }
        }
        worst = fmaxl(worst, sqrtl(change / size) / PERTURBED);
    }
    return worst;
}

static bool draw(sequence *const random, sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    joint_motion motion = draw_motion(random);
    for (int n = 0; !mechanism_close(m, &motion); n++) {
        if (n == TRIES) {
            return false;
        }
        motion = draw_motion(random);
    }
    memset(s, 0, sizeof *s);
    state_of(&motion, s->x);
    for (int i = 0; i < the_table.inputs; i++) {
        s->u[i] = (real)sequence_next(random, 10.0);
        s->input[i] = (wide)s->u[i];
    }
    iso_the_plant.derivative(s->dx, s->x, s->u, iso_the_plant.defaults);
    s->motion = motion_of(s->x, s->dx);
    if (!mechanism_close(m, &s->motion) || !mechanism_solve(m, &s->motion, s->input, &s->exact)) {
        return false;
    }
    s->condition = m->closures > 0 ? condition_of(s, random) : 1.0L;
    return true;
}

bool sample_all(sample s[STATES])
{
    sequence random = {UINT64_C(0x9E3779B97F4A7C15)};
    bool found = true;
    for (int k = 0; k < STATES; k++) {
        found = found && draw(&random, &s[k]);
    }
    return found;
}

wide sample_position_rates(const sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    const real *rate = s->dx;
    wide worst = 0.0L;
    for (int j = 0; j < m->bodies; j++) {
        const joint_kind kind = m->joint[j].kind;
        const int plain = kind == SPHERICAL ? 0 : kind == FREE ? 3 : joint_speeds(kind);
        for (int k = 0; k < plain; k++) {
            worst = (wide)*rate++ == (wide)(real)s->motion.v[j][k] ? worst : HUGE_VALL;
        }
        if (kind == SPHERICAL || kind == FREE) {
            /* q' = q (0, omega) / 2. */
            const wide *const q = s->motion.q[j] + plain;
            const wide *const v = s->motion.v[j] + plain;
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
    }
    return worst;
}
