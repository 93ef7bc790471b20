/* Energy, momentum and outputs of a moving mechanism. */
#include <string.h>

#include "tests/isoc/dynamics/mechanism.h"
#include "tests/isoc/dynamics/wide3.h"

jet mechanism_energy(const mechanism *const m, const joint_motion *const motion, const body_motion moved[BODIES_MAX])
{
    const jet3 gravity = jet3_constant(m->gravity);
    jet energy = jet_constant(0.0L);
    for (int i = 0; i < m->bodies; i++) {
        const body_motion *const b = &moved[i];
        const jet slide = jet_scale(m->body[i].mass / 2.0L, jet3_dot(b->velocity, b->velocity));
        const jet spin = jet_scale(0.5L, jet3_dot(b->omega, jet33_apply(&b->inertia, b->omega)));
        const jet height = jet_scale(-m->body[i].mass, jet3_dot(gravity, b->com));
        const jet stretch = {{motion->q[i][0] - m->joint[i].rest, motion->v[i][0], motion->a[i][0] / 2.0L}};
        const jet spring = jet_scale(m->joint[i].stiffness / 2.0L, jet_mul(stretch, stretch));
        energy = jet_add(energy, jet_add(jet_add(slide, spin), jet_add(height, spring)));
    }
    return energy;
}

momentum mechanism_momentum(const mechanism *const m, const body_motion moved[BODIES_MAX], const int root,
                            wide weight[3], wide weight_moment[3])
{
    const wide zero[3] = {0.0L, 0.0L, 0.0L};
    momentum sum = {jet3_constant(zero), jet3_constant(zero)};
    memcpy(weight, zero, sizeof zero);
    memcpy(weight_moment, zero, sizeof zero);
    for (int i = 0; i < m->bodies; i++) {
        if (!mechanism_carries(m, root, i)) {
            continue;
        }
        const body_motion *const b = &moved[i];
        const jet3 linear = jet3_scale(m->body[i].mass, b->velocity);
        sum.linear = jet3_add(sum.linear, linear);
        sum.angular = jet3_add(sum.angular, jet3_add(jet3_cross(b->com, linear), jet33_apply(&b->inertia, b->omega)));
        wide com[3];
        wide moment[3];
        part(b->com, 0, com);
        cross(com, m->gravity, moment);
        accumulate(weight, m->body[i].mass, m->gravity);
        accumulate(weight_moment, m->body[i].mass, moment);
    }
    return sum;
}

int output_numbers(const output_kind kind)
{
    switch (kind) {
    case POINT:
    case POINT_VELOCITY:
    case BODY_SPIN:
    case FORCE:
    case MOMENT:
        return 3;
    case ORIENTATION:
        return 4;
    default:
        return 1;
    }
}

/* The quaternion of a turn from its largest number, whose square the diagonal tells; w is not negative. */
static void quaternion_of(const jet33 *const turn, wide q[4])
{
    wide r[3][3];
    for (int i = 0; i < 9; i++) {
        r[i / 3][i % 3] = turn->m[i / 3][i % 3].c[0];
    }
    const wide trace = r[0][0] + r[1][1] + r[2][2];
    int largest = 0;
    wide square[4] = {1.0L + trace};
    for (int i = 0; i < 3; i++) {
        square[1 + i] = 1.0L + 2.0L * r[i][i] - trace;
        largest = square[1 + i] > square[largest] ? 1 + i : largest;
    }
    const wide number = sqrtl(square[largest]) / 2.0L;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const wide turned = (r[k][j] - r[j][k]) / (4.0L * number);
        if (largest == 0) {
            q[1 + i] = turned;
        } else if (largest == 1 + i) {
            q[0] = turned;
            q[1 + j] = (r[i][j] + r[j][i]) / (4.0L * number);
            q[1 + k] = (r[i][k] + r[k][i]) / (4.0L * number);
        }
    }
    q[largest] = number;
    for (int i = 3; i >= 0; i--) {
        q[i] = q[0] < 0.0L ? -q[i] : q[i];
    }
}

/* Of a body or a point on it. */
static void body_output(const tree_output *const o, const body_motion *const b, wide *const y)
{
    const jet3 at = jet3_add(b->body.origin, jet33_apply(&b->body.turn, jet3_constant(o->point)));
    if (o->kind == ORIENTATION) {
        quaternion_of(&b->body.turn, y);
    } else if (o->kind == BODY_SPIN) {
        const jet33 back = jet33_transposed(&b->body.turn);
        part(jet33_apply(&back, b->omega), 0, y);
    } else {
        part(at, o->kind == POINT ? 0 : 1, y);
    }
}

int mechanism_outputs(const mechanism *const m, const joint_motion *const motion, const solution *const solved,
                      wide *const y)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    int count = 0;
    for (int i = 0; i < m->outputs; i++) {
        const tree_output *const o = &m->output[i];
        wide *const to = y + count;
        switch (o->kind) {
        case POINT:
        case POINT_VELOCITY:
        case ORIENTATION:
        case BODY_SPIN:
            body_output(o, &moved[o->of], to);
            break;
        case FORCE:
            memcpy(to, solved->closure[o->of].force, 3 * sizeof *to);
            break;
        case MOMENT:
            memcpy(to, solved->closure[o->of].moment, 3 * sizeof *to);
            break;
        case ENERGY:
            *to = mechanism_energy(m, motion, moved).c[0];
            break;
        case TURNS:
        case VIOLATION:
            *to = 0.0L;
            break;
        default:
            *to = (o->kind == POSITION ? motion->q[o->of] : o->kind == SPEED ? motion->v[o->of] : motion->a[o->of])[0];
            break;
        }
        count += output_numbers(o->kind);
    }
    return count;
}
