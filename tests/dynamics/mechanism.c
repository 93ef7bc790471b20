#include "tests/dynamics/mechanism.h"

#include <string.h>

#define PI 3.14159265358979323846264338327950288L

/* Unknowns of one body and its joint, three numbers each but the last. */
enum { ACCELERATION_AT = 0, ALPHA_AT = 3, FORCE_AT = 6, MOMENT_AT = 9, QDD_AT = 12, PER_BODY = 13 };
enum { UNKNOWNS_MAX = PER_BODY * BODIES_MAX };

typedef struct linear_system {
    int n;
    wide a[UNKNOWNS_MAX][UNKNOWNS_MAX + 1]; /* the last column is the right-hand side */
} linear_system;

static void cross(const wide a[3], const wide b[3], wide out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* c[order] of each component. */
static void part(const jet3 a, const int order, wide out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a.x[i].c[order];
    }
}

static void unit(const wide a[3], wide out[3])
{
    const wide length = sqrtl(dot(a, a));
    for (int i = 0; i < 3; i++) {
        out[i] = a[i] / length;
    }
}

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

static jet33 placement_rotation(const placement *const p)
{
    const wide any[3] = {1.0L, 0.0L, 0.0L};
    return rotation(p->degrees != 0.0L ? p->axis : any, jet_constant(p->degrees * PI / 180.0L));
}

static pose ground_pose(void)
{
    const wide any[3] = {1.0L, 0.0L, 0.0L};
    const wide zero[3] = {0.0L, 0.0L, 0.0L};
    return (pose){.turn = rotation(any, jet_constant(0.0L)), .origin = jet3_constant(zero)};
}

/* The frame p of a body that stands at `on`. */
static pose placed(const pose *const on, const placement *const p)
{
    const jet33 turn = placement_rotation(p);
    return (pose){
        .turn = jet33_mul(&on->turn, &turn),
        .origin = jet3_add(on->origin, jet33_apply(&on->turn, jet3_constant(p->at))),
    };
}

/* The joint's frame on the child: turned about, or moved along, the axis. */
static pose displaced(const pose *const frame, const tree_joint *const joint, const jet q)
{
    pose moved = *frame;
    if (joint->kind == REVOLUTE) {
        const jet33 turn = rotation(joint->axis, q);
        moved.turn = jet33_mul(&frame->turn, &turn);
    } else if (joint->kind == PRISMATIC) {
        wide e[3];
        unit(joint->axis, e);
        const jet3 along = {{jet_scale(e[0], q), jet_scale(e[1], q), jet_scale(e[2], q)}};
        moved.origin = jet3_add(frame->origin, jet33_apply(&frame->turn, along));
    }
    return moved;
}

/* The pose of the child whose frame p stands at `frame`. */
static pose carried(const pose *const frame, const placement *const p)
{
    const jet33 turn = placement_rotation(p);
    const jet33 back = jet33_transposed(&turn);
    pose child = {.turn = jet33_mul(&frame->turn, &back)};
    child.origin = jet3_add(frame->origin, jet3_scale(-1.0L, jet33_apply(&child.turn, jet3_constant(p->at))));
    return child;
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

int mechanism_freedoms(const mechanism *const m)
{
    int count = 0;
    for (int i = 0; i < m->bodies; i++) {
        count += m->joint[i].kind != FIXED;
    }
    return count;
}

void mechanism_move(const mechanism *const m, const joint_motion *const motion, body_motion out[BODIES_MAX])
{
    const pose ground = ground_pose();
    for (int i = 0; i < m->bodies; i++) {
        const tree_joint *const joint = &m->joint[i];
        const jet q = {{motion->q[i], motion->qd[i], motion->qdd[i] / 2.0L}};
        const pose inner = placed(joint->parent == GROUND ? &ground : &out[joint->parent].body, &joint->on_parent);
        const pose outer = displaced(&inner, joint, q);
        body_motion *const b = &out[i];
        b->body = carried(&outer, &joint->on_child);
        b->com = jet3_add(b->body.origin, jet33_apply(&b->body.turn, jet3_constant(m->body[i].com)));
        b->velocity = jet3_rate(b->com);
        b->omega = angular_velocity(&b->body.turn);
        b->inertia = world_inertia(&m->body[i], &b->body.turn);
        part(outer.origin, 0, b->hinge);
        wide e[3];
        unit(joint->axis, e);
        part(jet33_apply(&inner.turn, jet3_constant(e)), 0, b->axis);
    }
}

wide mechanism_force(const mechanism *const m, const int j, const joint_motion *const motion, const wide *const u)
{
    const tree_joint *const joint = &m->joint[j];
    const wide drive = joint->input == 0 ? 0.0L : u[joint->input - 1];
    return drive - joint->damping * motion->qd[j] - joint->stiffness * (motion->q[j] - joint->rest);
}

/* Adds k times an unknown vector to three rows. */
static void add_same(linear_system *const s, const int row, const int column, const wide k)
{
    for (int i = 0; i < 3; i++) {
        s->a[row + i][column + i] += k;
    }
}

/* Adds k (r x unknown) to three rows. */
static void add_cross(linear_system *const s, const int row, const int column, const wide k, const wide r[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int l = (i + 2) % 3;
        s->a[row + i][column + l] += k * r[j];
        s->a[row + i][column + j] -= k * r[l];
    }
}

static void add_right(linear_system *const s, const int row, const wide k, const wide v[3])
{
    for (int i = 0; i < 3; i++) {
        s->a[row + i][s->n] += k * v[i];
    }
}

/* From the body's centre of mass to the hinge of joint j. */
static void arm_to(const body_motion moved[BODIES_MAX], const int body, const int j, wide out[3])
{
    wide com[3];
    part(moved[body].com, 0, com);
    for (int i = 0; i < 3; i++) {
        out[i] = moved[j].hinge[i] - com[i];
    }
}

/* Newton and Euler of body i: m a - F_in + sum F_out = m g;
 * I alpha - (r x F + N)_in + sum (r x F + N)_out = -omega x I omega. */
static void add_body(linear_system *const s, const mechanism *const m, const body_motion moved[BODIES_MAX], const int i)
{
    const int row = PER_BODY * i;
    const int own = PER_BODY * i;
    wide omega[3];
    wide spin[3];
    wide gyroscopic[3];
    part(moved[i].omega, 0, omega);
    part(jet33_apply(&moved[i].inertia, moved[i].omega), 0, spin);
    cross(omega, spin, gyroscopic);

    add_same(s, row, own + ACCELERATION_AT, m->body[i].mass);
    add_right(s, row, m->body[i].mass, m->gravity);
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            s->a[row + 3 + r][own + ALPHA_AT + c] += moved[i].inertia.m[r][c].c[0];
        }
    }
    add_right(s, row + 3, -1.0L, gyroscopic);
    for (int j = 0; j < m->bodies; j++) {
        if (j == i || m->joint[j].parent == i) {
            const wide sign = j == i ? -1.0L : 1.0L;
            const int at = PER_BODY * j;
            wide arm[3];
            arm_to(moved, i, j, arm);
            add_same(s, row, at + FORCE_AT, sign);
            add_cross(s, row + 3, at + FORCE_AT, sign, arm);
            add_same(s, row + 3, at + MOMENT_AT, sign);
        }
    }
}

/* sign times the acceleration of body b's point at the hinge of joint j: a + alpha x r + omega x (omega x r);
 * and sign alpha in the next three rows. */
static void add_point(linear_system *const s, const body_motion moved[BODIES_MAX], const int b, const int j,
                      const int row, const wide sign)
{
    wide arm[3];
    wide omega[3];
    wide swirl[3];
    wide centripetal[3];
    arm_to(moved, b, j, arm);
    part(moved[b].omega, 0, omega);
    cross(omega, arm, swirl);
    cross(omega, swirl, centripetal);
    add_same(s, row, PER_BODY * b + ACCELERATION_AT, sign);
    add_cross(s, row, PER_BODY * b + ALPHA_AT, -sign, arm);
    add_right(s, row, -sign, centripetal);
    add_same(s, row + 3, PER_BODY * b + ALPHA_AT, sign);
}

/* Constraints of joint j: the child's point at the hinge moves against the parent's by e q'' + 2 omega x e q' (sliding)
 * or not at all; the child turns against the parent by e q'' + omega x e q' (turning) or not at all. The reaction has
 * the generalised force along the freedom. */
static void add_joint(linear_system *const s, const mechanism *const m, const body_motion moved[BODIES_MAX],
                      const int j, const wide qd, const wide force)
{
    const tree_joint *const joint = &m->joint[j];
    const int row = PER_BODY * j + 6;
    const int own = PER_BODY * j;
    const wide *const e = moved[j].axis;
    add_point(s, moved, j, j, row, 1.0L);
    wide carried_by[3] = {0.0L, 0.0L, 0.0L};
    if (joint->parent != GROUND) {
        wide omega[3];
        part(moved[joint->parent].omega, 0, omega);
        cross(omega, e, carried_by);
        add_point(s, moved, joint->parent, j, row, -1.0L);
    }
    if (joint->kind == FIXED) {
        s->a[row + 6][own + QDD_AT] = 1.0L;
        return;
    }
    const bool slides = joint->kind == PRISMATIC;
    const int free_row = slides ? row : row + 3;
    add_right(s, free_row, slides ? 2.0L * qd : qd, carried_by);
    for (int i = 0; i < 3; i++) {
        s->a[free_row + i][own + QDD_AT] -= e[i];
        s->a[row + 6][own + (slides ? FORCE_AT : MOMENT_AT) + i] = e[i];
    }
    s->a[row + 6][s->n] = force;
}

/* Divides each row by its largest entry, so that pivots are chosen among like numbers. */
static void equilibrate(linear_system *const s)
{
    for (int r = 0; r < s->n; r++) {
        wide largest = 0.0L;
        for (int c = 0; c < s->n; c++) {
            largest = fmaxl(largest, fabsl(s->a[r][c]));
        }
        for (int c = 0; c <= s->n && largest > 0.0L; c++) {
            s->a[r][c] /= largest;
        }
    }
}

static void swap_rows(linear_system *const s, const int a, const int b)
{
    wide kept[UNKNOWNS_MAX + 1];
    memcpy(kept, s->a[a], sizeof kept);
    memcpy(s->a[a], s->a[b], sizeof kept);
    memcpy(s->a[b], kept, sizeof kept);
}

/* Gauss's elimination with row pivoting; the solution takes the place of the right-hand side. */
static bool eliminate(linear_system *const s)
{
    const int n = s->n;
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int r = k + 1; r < n; r++) {
            pivot = fabsl(s->a[r][k]) > fabsl(s->a[pivot][k]) ? r : pivot;
        }
        if (fabsl(s->a[pivot][k]) < 1e-15L) {
            return false;
        }
        swap_rows(s, k, pivot);
        for (int r = k + 1; r < n; r++) {
            const wide factor = s->a[r][k] / s->a[k][k];
            for (int c = k; c <= n && factor != 0.0L; c++) {
                s->a[r][c] -= factor * s->a[k][c];
            }
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int c = k + 1; c < n; c++) {
            s->a[k][n] -= s->a[k][c] * s->a[c][n];
        }
        s->a[k][n] /= s->a[k][k];
    }
    return true;
}

bool mechanism_solve(const mechanism *const m, const joint_motion *const motion, const wide *const u,
                     solution *const out)
{
    static linear_system s;
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    memset(&s, 0, sizeof s);
    s.n = PER_BODY * m->bodies;
    for (int i = 0; i < m->bodies; i++) {
        add_body(&s, m, moved, i);
        add_joint(&s, m, moved, i, motion->qd[i], mechanism_force(m, i, motion, u));
    }
    equilibrate(&s);
    if (!eliminate(&s)) {
        return false;
    }
    for (int i = 0; i < m->bodies; i++) {
        const int at = PER_BODY * i;
        for (int c = 0; c < 3; c++) {
            out->acceleration[i][c] = s.a[at + ACCELERATION_AT + c][s.n];
            out->reaction[i].force[c] = s.a[at + FORCE_AT + c][s.n];
            out->reaction[i].moment[c] = s.a[at + MOMENT_AT + c][s.n];
        }
        out->qdd[i] = s.a[at + QDD_AT][s.n];
    }
    return true;
}

jet mechanism_energy(const mechanism *const m, const joint_motion *const motion, const body_motion moved[BODIES_MAX])
{
    const jet3 gravity = jet3_constant(m->gravity);
    jet energy = jet_constant(0.0L);
    for (int i = 0; i < m->bodies; i++) {
        const body_motion *const b = &moved[i];
        const jet slide = jet_scale(m->body[i].mass / 2.0L, jet3_dot(b->velocity, b->velocity));
        const jet spin = jet_scale(0.5L, jet3_dot(b->omega, jet33_apply(&b->inertia, b->omega)));
        const jet height = jet_scale(-m->body[i].mass, jet3_dot(gravity, b->com));
        const jet stretch = {{motion->q[i] - m->joint[i].rest, motion->qd[i], motion->qdd[i] / 2.0L}};
        const jet spring = jet_scale(m->joint[i].stiffness / 2.0L, jet_mul(stretch, stretch));
        energy = jet_add(energy, jet_add(jet_add(slide, spin), jet_add(height, spring)));
    }
    return energy;
}

bool mechanism_carries(const mechanism *const m, const int root, const int body)
{
    int at = body;
    while (at != GROUND && at != root) {
        at = m->joint[at].parent;
    }
    return at == root;
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
        for (int c = 0; c < 3; c++) {
            weight[c] += m->body[i].mass * m->gravity[c];
            weight_moment[c] += m->body[i].mass * moment[c];
        }
    }
    return sum;
}

int mechanism_outputs(const mechanism *const m, const joint_motion *const motion, wide *const y)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    int count = 0;
    for (int i = 0; i < m->outputs; i++) {
        const tree_output *const o = &m->output[i];
        const bool vector = o->kind == POINT || o->kind == POINT_VELOCITY;
        if (vector) {
            const pose *const b = &moved[o->of].body;
            const jet3 at = jet3_add(b->origin, jet33_apply(&b->turn, jet3_constant(o->point)));
            part(at, o->kind == POINT ? 0 : 1, y + count);
        } else if (o->kind == ENERGY) {
            y[count] = mechanism_energy(m, motion, moved).c[0];
        } else {
            const wide *const of = o->kind == POSITION ? motion->q : o->kind == SPEED ? motion->qd : motion->qdd;
            y[count] = o->kind == TURNS ? 0.0L : of[o->of];
        }
        count += vector ? 3 : 1;
    }
    return count;
}
