#include "tests/isoc/dynamics/generate.h"

#include <string.h>

#include "tests/isoc/dynamics/random.h"
#include "tests/isoc/dynamics/wide3.h"

#define PI 3.14159265358979323846264338327950288L

/* Rows of closures nearer to dependent than this are drawn anew: rounding would show more than errors do. */
#define INDEPENDENT 0.2L

enum { TRIES = 1000, FIRST_BODIES = 2, DOFS_MOST = 9 };

static const joint_kind closure_kinds[GENERATED_CLOSURES] = {FIXED,    REVOLUTE, PRISMATIC, SPHERICAL, LINE,
                                                             DISTANCE, ROLLING,  GEAR,      MOTION};
static const int closure_rows[] = {
    [FIXED] = 6,    [REVOLUTE] = 5, [PRISMATIC] = 5, [SPHERICAL] = 3, [LINE] = 2,
    [DISTANCE] = 1, [ROLLING] = 3,  [GEAR] = 1,      [MOTION] = 1,
};

/* --- numbers, which the scene can write: doubles --- */

static wide number(sequence *const random, const double bound)
{
    return (wide)sequence_next(random, bound);
}

/* From `least` to `most`. */
static wide between(sequence *const random, const double least, const double most)
{
    return (wide)(double)((wide)((least + most) / 2.0) + number(random, (most - least) / 2.0));
}

static int choice(sequence *const random, const int count)
{
    const int chosen = (int)((sequence_next(random, 0.5) + 0.5) * count);
    return chosen < count ? chosen : count - 1;
}

static void vector(sequence *const random, const double bound, wide out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = number(random, bound);
    }
}

static void round_all(wide *const numbers, const int count)
{
    for (int i = 0; i < count; i++) {
        numbers[i] = (wide)(double)numbers[i];
    }
}

static placement place(sequence *const random, const double bound)
{
    placement made;
    vector(random, bound, made.at);
    made.degrees = number(random, 120.0);
    vector(random, 1.0, made.axis);
    return made;
}

static void coordinate_axis(sequence *const random, wide out[3])
{
    memset(out, 0, 3 * sizeof *out);
    out[choice(random, 3)] = number(random, 1.0) < 0.0L ? -1.0L : 1.0L;
}

/* --- the tree --- */

static void draw_body(sequence *const random, rigid_body *const body)
{
    body->mass = between(random, 0.5, 2.0);
    vector(random, 0.2, body->com);
    for (int i = 0; i < 6; i++) {
        body->inertia[i] = i < 3 ? between(random, 0.04, 0.06) : number(random, 0.005);
    }
}

static void draw_joint(sequence *const random, const joint_kind kind, const int parent, tree_joint *const joint)
{
    memset(joint, 0, sizeof *joint);
    joint->kind = kind;
    joint->parent = parent;
    joint->on_parent = place(random, 0.4);
    joint->on_child = place(random, 0.2);
    if (kind == UNIVERSAL || kind == PLANAR) {
        coordinate_axis(random, joint->axis);
    } else {
        vector(random, 1.0, joint->axis);
    }
    for (int i = 0; i < 3; i++) {
        joint->axis[i] = kind == PLANAR ? fabsl(joint->axis[i]) : joint->axis[i];
        joint->second[(i + 1) % 3] = joint->axis[i];
    }
    if (number(random, 1.0) < 0.0L && kind != FIXED) {
        joint->damping = between(random, 0.1, 0.5);
        joint->spin_damping = has_one_coordinate(kind) ? 0.0L : between(random, 0.05, 0.2);
    }
    if (has_one_coordinate(kind) && number(random, 1.0) < 0.0L) {
        joint->stiffness = between(random, 1.0, 5.0);
        joint->rest = number(random, 0.3);
    }
}

static void draw_start(sequence *const random, const joint_kind kind, const int j, joint_motion *const motion)
{
    wide *const q = motion->q[j];
    for (int k = 0; k < joint_coordinates(kind); k++) {
        q[k] = number(random, coordinate_slides(kind, k) ? 0.2 : 1.0);
    }
    for (int k = 0; k < joint_speeds(kind); k++) {
        motion->v[j][k] = number(random, coordinate_slides(kind, k) ? 0.5 : 2.0);
    }
    if (kind == SPHERICAL || kind == FREE) {
        wide *const turn = q + joint_coordinates(kind) - 4;
        const wide length = sqrtl(turn[0] * turn[0] + dot(turn + 1, turn + 1));
        for (int k = 0; k < 4; k++) {
            turn[k] /= length;
        }
    }
}

/* A further body with its joint. */
static void add_body(sequence *const random, const joint_kind kind, const int parent, generated *const out)
{
    const int j = out->mechanism.bodies++;
    draw_body(random, &out->mechanism.body[j]);
    draw_joint(random, kind, parent, &out->mechanism.joint[j]);
    draw_start(random, kind, j, &out->start);
}

static joint_kind draw_kind(sequence *const random, const int dofs_left)
{
    joint_kind kind = REVOLUTE;
    do {
        kind = (joint_kind)choice(random, GENERATED_KINDS);
    } while (joint_speeds(kind) > dofs_left);
    return kind;
}

/* One body on the ground that moves, one on that by a joint of this kind, and one or two more. */
static void draw_tree(sequence *const random, const joint_kind kind, const bool single, generated *const out)
{
    const int bodies = FIRST_BODIES + 1 + choice(random, 2);
    joint_kind first = REVOLUTE;
    do {
        first = single ? (joint_kind)choice(random, 2) + REVOLUTE : draw_kind(random, DOFS_MOST - joint_speeds(kind));
    } while (first == FIXED);
    add_body(random, first, GROUND, out);
    add_body(random, kind, 0, out);
    while (out->mechanism.bodies < bodies) {
        const int left = DOFS_MOST - mechanism_dofs(&out->mechanism), made = out->mechanism.bodies;
        const joint_kind next = draw_kind(random, left);
        add_body(random, next, next == FIXED ? choice(random, made) : choice(random, made + 1) - 1, out);
    }
}

/* One input pushes the last body; another one drives the first joint that can be driven. */
static void draw_inputs(sequence *const random, generated *const out)
{
    mechanism *const m = &out->mechanism;
    out->inputs = 1;
    for (int j = 0; j < m->bodies; j++) {
        if (has_one_coordinate(m->joint[j].kind)) {
            m->joint[j].input = 2;
            out->inputs = 2;
            break;
        }
    }
    m->applied_forces = 1;
    applied_force *const force = &m->applied_force[0];
    force->body = m->bodies - 1;
    vector(random, 0.2, force->at);
    vector(random, 1.0, force->axis);
    force->lever = number(random, 0.1);
    force->input = 1;
    for (int i = 0; i < GENERATED_INPUTS; i++) {
        out->input[i] = number(random, 3.0);
    }
}

/* --- closures --- */

/* Degrees of freedom between two bodies. */
static int path_dofs(const mechanism *const m, const int a, const int b)
{
    int count = 0;
    for (int j = 0; j < m->bodies; j++) {
        const bool carries_a = mechanism_carries(m, j, a);
        count += carries_a != mechanism_carries(m, j, b) ? joint_speeds(m->joint[j].kind) : 0;
    }
    return count;
}

/* The turn R as degrees about an axis; false near where that is undetermined. */
static bool axis_of_turn(wide r[3][3], placement *const to)
{
    const wide twice[3] = {r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
    const wide sine = sqrtl(dot(twice, twice)) / 2.0L;
    to->degrees = atan2l(sine, (r[0][0] + r[1][1] + r[2][2] - 1.0L) / 2.0L) * 180.0L / PI;
    memcpy(to->axis, twice, sizeof to->axis);
    round_all(&to->degrees, 1);
    round_all(to->axis, 3);
    return sine > 0.1L;
}

/* The frame on a body that stands there in the world. */
static bool frame_at(const body_motion moved[BODIES_MAX], const int body, const pose *const frame, const wide origin[3],
                     placement *const to)
{
    const placement none = {{0.0L}, 0.0L, {0.0L}};
    const pose on = frame_on(pose_of(moved, body), &none);
    wide r[3][3];
    for (int i = 0; i < 3; i++) {
        to->at[i] = 0.0L;
        for (int k = 0; k < 3; k++) {
            to->at[i] += on.turn.m[k][i].c[0] * (origin[k] - on.origin.x[k].c[0]);
            r[i][k] = 0.0L;
            for (int n = 0; n < 3; n++) {
                r[i][k] += on.turn.m[n][i].c[0] * frame->turn.m[n][k].c[0];
            }
        }
    }
    round_all(to->at, 3);
    return axis_of_turn(r, to);
}

/* Where the parent's frame has to be, for that of the child. */
static void meet(sequence *const random, loop_closure *const c, const pose *const child, wide origin[3])
{
    wide axis[3];
    wide off[3] = {0.0L, 0.0L, 0.0L};
    part(child->origin, 0, origin);
    part(jet33_apply(&child->turn, jet3_constant(c->axis)), 0, axis);
    if (c->kind == PRISMATIC || c->kind == LINE) {
        accumulate(origin, number(random, 0.2), axis);
    } else if (c->kind == ROLLING) {
        c->length = between(random, 0.2, 0.4);
        const wide along = dot(c->axis, c->wheel);
        accumulate(origin, -c->length * sqrtl(1.0L - along * along), axis);
    } else if (c->kind == DISTANCE) {
        vector(random, 1.0, off);
        c->length = between(random, 0.3, 0.6);
        accumulate(origin, c->length / sqrtl(dot(off, off)), off);
    }
}

/* A closure that holds at the start, between bodies with enough degrees of freedom between them. */
static bool add_closure(sequence *const random, const joint_kind kind, const bool is_disc, generated *const out)
{
    mechanism *const m = &out->mechanism;
    loop_closure *const c = &m->closure[m->closures];
    wide origin[3];
    c->kind = kind;
    coordinate_axis(random, c->axis);
    if (kind == ROLLING && is_disc) {
        /* An inclined disc; the sides of a right triangle. */
        for (int i = 0; i < 3; i++) {
            c->wheel[i] = c->axis[i] * (wide)0.28 + c->axis[(i + 1) % 3] * (wide)0.96;
        }
    }
    for (int tries = 0; tries < TRIES; tries++) {
        c->child = choice(random, m->bodies);
        c->parent = kind == ROLLING ? GROUND : choice(random, m->bodies + 1) - 1;
        if (c->child != c->parent && path_dofs(m, c->parent, c->child) > closure_rows[kind]) {
            body_motion moved[BODIES_MAX];
            mechanism_move(m, &out->start, moved);
            c->on_child = place(random, 0.2);
            const pose child = frame_on(pose_of(moved, c->child), &c->on_child);
            meet(random, c, &child, origin);
            m->closures++;
            return frame_at(moved, c->parent, &child, origin, &c->on_parent);
        }
    }
    return false;
}

/* The number of joints before `before` that can be coupled; `at` becomes the last of them. */
static int last_single(const mechanism *const m, const int before, int *const at)
{
    int count = 0;
    for (int j = 0; j < before; j++) {
        *at = has_one_coordinate(m->joint[j].kind) ? j : *at;
        count += has_one_coordinate(m->joint[j].kind);
    }
    return count;
}

static bool add_coupling(sequence *const random, const joint_kind kind, generated *const out)
{
    mechanism *const m = &out->mechanism;
    coupling *const c = &m->coupling[m->couplings];
    const bool is_gear = kind == GEAR;
    if (m->couplings == COUPLINGS_MAX || last_single(m, m->bodies, &c->first) < (is_gear ? 2 : 1)) {
        return false;
    }
    c->second = GROUND;
    const wide q = out->start.q[c->first][0];
    if (is_gear) {
        (void)last_single(m, c->first, &c->second);
        c->ratio = between(random, 0.5, 2.0);
        c->offset = q - c->ratio * out->start.q[c->second][0];
    } else {
        c->swing = (wide)(double)(fabsl(q) + between(random, 0.1, 0.3));
        c->omega = 2.0L * PI * between(random, 0.3, 0.8);
        c->phase = (wide)(double)asinl(q / c->swing);
    }
    m->couplings++;
    return true;
}

/* What rolls is a disc in every second seed, else a ball. */
static bool close_once(sequence *const random, const joint_kind kind, const int seed, generated *const out)
{
    return kind > ROLLING ? add_coupling(random, kind, out) : add_closure(random, kind, seed % 2 == 0, out);
}

static int all_rows(const mechanism *const m)
{
    int rows = m->couplings;
    for (int n = 0; n < m->closures; n++) {
        rows += closure_rows[m->closure[n].kind];
    }
    return rows;
}

/* --- all --- */

static bool draw(sequence *const random, const bool closed, const int seed, generated *const out)
{
    static const char *const stabilisations[] = {NULL, "projection { iterations 2 }", "lagrangian { penalty 1e5 kg }",
                                                 "baumgarte { alpha 5 Hz; beta 5 Hz }", "none"};
    const joint_kind closing = closure_kinds[(seed - 1) % GENERATED_CLOSURES];
    const bool couples = closed && closing > ROLLING;
    joint_kind kind = (joint_kind)((seed - 1) % GENERATED_KINDS);
    memset(out, 0, sizeof *out);
    vector(random, 10.0, out->mechanism.gravity);
    kind = couples && closing == GEAR && !has_one_coordinate(kind) ? REVOLUTE : kind;
    draw_tree(random, kind, couples, out);
    draw_inputs(random, out);
    out->has_load = seed % 3 == 0;
    if (!closed) {
        return true;
    }
    if (closure_rows[closing] > 4) {
        add_body(random, FREE, GROUND, out);
    }
    out->stabilisation = stabilisations[(seed - 1) * 3 / 7 % 5];
    if (!close_once(random, closing, seed, out)) {
        return false;
    }
    if (seed % 3 == 1 && closing != DISTANCE && !close_once(random, seed % 2 == 0 ? LINE : DISTANCE, seed, out)) {
        return false;
    }
    out->has_reach = out->mechanism.closures > 0 && out->mechanism.closure[0].kind == DISTANCE && seed % 2 == 0;
    const bool moves = all_rows(&out->mechanism) < mechanism_dofs(&out->mechanism);
    return moves && mechanism_close(&out->mechanism, &out->start) &&
           mechanism_independence(&out->mechanism, &out->start) >= INDEPENDENT;
}

bool generate(const bool closed, const int seed, generated *const out)
{
    sequence random = {UINT64_C(0x9E3779B97F4A7C15) * (uint64_t)(2 * seed + closed)};
    bool made = false;
    for (int tries = 0; tries < TRIES && !made; tries++) {
        made = draw(&random, closed, seed, out);
    }
    return made;
}
