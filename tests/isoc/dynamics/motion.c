/* Where bodies are and how they move, from the motion of the joints. */
#include <string.h>

#include "tests/isoc/dynamics/mechanism.h"
#include "tests/isoc/dynamics/wide3.h"

#define PI 3.14159265358979323846264338327950288L

/* Rodrigues (1840): cos I + (1 - cos) e e' + sin [e x]. */
static jet33 rotation(const wide axis[3], const jet angle)
{
    wide e[3];
    unit(axis, e);
    const jet s = jet_sin(angle);
    const jet c = jet_cos(angle);
    const jet versine = jet_sub(jet_constant(1.0L), c);
    const wide skew[3][3] = {{0.0L, -e[2], e[1]}, {e[2], 0.0L, -e[0]}, {-e[1], e[0], 0.0L}};
    jet33 r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r.m[i][j] = jet_add(jet_scale(e[i] * e[j], versine), jet_scale(skew[i][j], s));
        }
        r.m[i][i] = jet_add(r.m[i][i], c);
    }
    return r;
}

static jet33 no_rotation(void)
{
    static const jet33 none = {{{{{1.0L}}}, {{{0.0L}}, {{1.0L}}}, {{{0.0L}}, {{0.0L}}, {{1.0L}}}}};
    return none;
}

/* The pose of the child whose frame p stands at `frame`. */
static pose carried(const pose *const frame, const placement *const p)
{
    pose child = {.turn = frame->turn};
    if (p->degrees != 0.0L) {
        const jet33 back = rotation(p->axis, jet_constant(-p->degrees * PI / 180.0L));
        child.turn = jet33_mul(&frame->turn, &back);
    }
    child.origin = jet3_add(frame->origin, jet3_scale(-1.0L, jet33_apply(&child.turn, jet3_constant(p->at))));
    return child;
}

pose frame_on(const pose *const on, const placement *const p)
{
    const wide zero[3] = {0.0L, 0.0L, 0.0L};
    const pose ground = {no_rotation(), jet3_constant(zero)};
    const pose *const body = on == NULL ? &ground : on;
    pose frame = {body->turn, jet3_add(body->origin, jet33_apply(&body->turn, jet3_constant(p->at)))};
    if (p->degrees != 0.0L) {
        const jet33 turn = rotation(p->axis, jet_constant(p->degrees * PI / 180.0L));
        frame.turn = jet33_mul(&body->turn, &turn);
    }
    return frame;
}

/* Hamilton's product p (0, v) / 2. */
static void half_product(const wide p[4], const wide v[3], wide out[4])
{
    wide turned[3];
    cross(p + 1, v, turned);
    out[0] = -dot(p + 1, v) / 2.0L;
    for (int i = 0; i < 3; i++) {
        out[1 + i] = (p[0] * v[i] + turned[i]) / 2.0L;
    }
}

/* The turn of a quaternion q, made of unit length, with q' = q (0, omega) / 2. */
static jet33 quaternion_rotation(const wide given[4], const wide omega[3], const wide alpha[3])
{
    const wide length = sqrtl(given[0] * given[0] + dot(given + 1, given + 1));
    wide q[4];
    wide rate[4];
    wide of_rate[4];
    wide of_alpha[4];
    jet p[4];
    for (int i = 0; i < 4; i++) {
        q[i] = given[i] / length;
    }
    half_product(q, omega, rate);
    half_product(rate, omega, of_rate);
    half_product(q, alpha, of_alpha);
    for (int i = 0; i < 4; i++) {
        p[i] = (jet){{q[i], rate[i], (of_rate[i] + of_alpha[i]) / 2.0L}};
    }
    /* R v = v + 2 w (p x v) + 2 p x (p x v), column by column. */
    const jet3 vector = {{p[1], p[2], p[3]}};
    jet33 r;
    for (int c = 0; c < 3; c++) {
        wide e[3] = {0.0L, 0.0L, 0.0L};
        e[c] = 1.0L;
        const jet3 once = jet3_cross(vector, jet3_constant(e));
        const jet3 twice = jet3_cross(vector, once);
        for (int i = 0; i < 3; i++) {
            r.m[i][c] = jet_add(jet_constant(e[i]), jet_scale(2.0L, jet_add(jet_mul(p[0], once.x[i]), twice.x[i])));
        }
    }
    return r;
}

/* Numbers of coordinates; how many of them slide, and how many turns there are about axes. */
static const struct {
    int coordinates, speeds, slides, turns;
} dofs[] = {
    [FIXED] = {0, 0, 0, 0},       [REVOLUTE] = {1, 1, 0, 1}, [PRISMATIC] = {1, 1, 1, 0}, [UNIVERSAL] = {2, 2, 0, 2},
    [CYLINDRICAL] = {2, 2, 1, 1}, [PLANAR] = {3, 3, 2, 1},   [SPHERICAL] = {4, 3, 0, 0}, [FREE] = {7, 6, 3, 0},
};

int joint_coordinates(const joint_kind kind)
{
    return dofs[kind].coordinates;
}

int joint_speeds(const joint_kind kind)
{
    return dofs[kind].speeds;
}

/* The direction of slide n in the parent's frame. */
static void slide_direction(const tree_joint *const joint, const int n, wide out[3])
{
    if (joint->kind == PLANAR || joint->kind == FREE) {
        int first = 0;
        for (int i = 0; i < 3 && joint->kind == PLANAR; i++) {
            first = joint->axis[i] != 0.0L ? i + 1 : first;
        }
        for (int i = 0; i < 3; i++) {
            out[i] = i == (first + n) % 3 ? 1.0L : 0.0L;
        }
    } else {
        unit(joint->axis, out);
    }
}

/* The child's frame in the parent's, for coordinates q, speeds v and accelerations a: slid, then turned. */
static pose displacement(const tree_joint *const joint, const wide *const q, const wide *const v, const wide *const a)
{
    const wide zero[3] = {0.0L, 0.0L, 0.0L};
    pose moved = {no_rotation(), jet3_constant(zero)};
    const int slides = dofs[joint->kind].slides;
    for (int n = 0; n < slides; n++) {
        wide e[3];
        slide_direction(joint, n, e);
        const jet along = {{q[n], v[n], a[n] / 2.0L}};
        moved.origin =
            jet3_add(moved.origin, (jet3){{jet_scale(e[0], along), jet_scale(e[1], along), jet_scale(e[2], along)}});
    }
    for (int n = 0; n < dofs[joint->kind].turns; n++) {
        const int k = slides + n;
        const jet33 turn = rotation(n == 0 ? joint->axis : joint->second, (jet){{q[k], v[k], a[k] / 2.0L}});
        moved.turn = jet33_mul(&moved.turn, &turn);
    }
    if (joint->kind == SPHERICAL || joint->kind == FREE) {
        moved.turn = quaternion_rotation(q + slides, v + slides, a + slides);
    }
    return moved;
}

/* R' R^T = [omega x]. */
static jet3 angular_velocity(const jet33 *const turn)
{
    jet33 rate;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            rate.m[i][j] = jet_rate(turn->m[i][j]);
        }
    }
    const jet33 back = jet33_transposed(turn);
    const jet33 skew = jet33_mul(&rate, &back);
    return (jet3){{skew.m[2][1], skew.m[0][2], skew.m[1][0]}};
}

static jet33 world_inertia(const rigid_body *const body, const jet33 *const turn)
{
    static const int entry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    jet33 own;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            own.m[i][j] = jet_constant(body->inertia[entry[i][j]]);
        }
    }
    const jet33 back = jet33_transposed(turn);
    const jet33 half = jet33_mul(turn, &own);
    return jet33_mul(&half, &back);
}

int mechanism_coordinates(const mechanism *const m)
{
    int count = 0;
    for (int i = 0; i < m->bodies; i++) {
        count += joint_coordinates(m->joint[i].kind);
    }
    return count;
}

int mechanism_dofs(const mechanism *const m)
{
    int count = 0;
    for (int i = 0; i < m->bodies; i++) {
        count += joint_speeds(m->joint[i].kind);
    }
    return count;
}

bool mechanism_carries(const mechanism *const m, const int root, const int body)
{
    int at = body;
    while (at != GROUND && at != root) {
        at = m->joint[at].parent;
    }
    return body != GROUND && at == root;
}

/* What one unit of each speed does, in world axes. */
static void directions(const tree_joint *const joint, const wide *const q, const pose *const inner,
                       body_motion *const b)
{
    const wide still[SPEEDS_MAX] = {0.0L};
    for (int k = 0; k < joint_speeds(joint->kind); k++) {
        wide v[SPEEDS_MAX] = {0.0L};
        v[k] = 1.0L;
        const pose moved = displacement(joint, q, v, still);
        wide slide[3];
        wide turn[3];
        part(moved.origin, 1, slide);
        part(angular_velocity(&moved.turn), 0, turn);
        part(jet33_apply(&inner->turn, jet3_constant(slide)), 0, b->slide[k]);
        part(jet33_apply(&inner->turn, jet3_constant(turn)), 0, b->turn[k]);
    }
}

void mechanism_move_body(const mechanism *const m, const joint_motion *const motion, const int i,
                         body_motion out[BODIES_MAX])
{
    const tree_joint *const joint = &m->joint[i];
    const pose inner = frame_on(pose_of(out, joint->parent), &joint->on_parent);
    const pose moved = displacement(joint, motion->q[i], motion->v[i], motion->a[i]);
    const pose outer = {
        .turn = jet33_mul(&inner.turn, &moved.turn),
        .origin = jet3_add(inner.origin, jet33_apply(&inner.turn, moved.origin)),
    };
    body_motion *const b = &out[i];
    b->body = carried(&outer, &joint->on_child);
    b->com = jet3_add(b->body.origin, jet33_apply(&b->body.turn, jet3_constant(m->body[i].com)));
    b->velocity = jet3_rate(b->com);
    b->omega = angular_velocity(&b->body.turn);
    b->inertia = world_inertia(&m->body[i], &b->body.turn);
    part(outer.origin, 0, b->hinge);
    directions(joint, motion->q[i], &inner, b);
}

void mechanism_move(const mechanism *const m, const joint_motion *const motion, body_motion out[BODIES_MAX])
{
    for (int i = 0; i < m->bodies; i++) {
        mechanism_move_body(m, motion, i, out);
    }
}
