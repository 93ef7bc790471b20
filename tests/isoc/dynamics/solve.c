/* Accelerations and reactions: M a - J' lambda = Q of all bodies, J a = -bias of all joints and closures. */
#include <string.h>

#include "tests/isoc/dynamics/hold.h"
#include "tests/isoc/dynamics/linear.h"
#include "tests/isoc/dynamics/mechanism.h"
#include "tests/isoc/dynamics/wide3.h"

/* An equation follows from others also where lengths are as wrong as those of a test of condition. */
#define LEAST_PIVOT 1e-7L

/* Unknowns of one body. */
enum { ACCELERATION_AT = 0, ALPHA_AT = 3, PER_BODY = 6 };

wide mechanism_effort(const mechanism *const m, const int j, const int k, const joint_motion *const motion,
                      const wide *const u)
{
    const tree_joint *const joint = &m->joint[j];
    const wide drive = joint->input == 0 ? 0.0L : u[joint->input - 1];
    const bool single = joint->kind == REVOLUTE || joint->kind == PRISMATIC;
    const int slides = joint->kind == FREE ? 3 : joint->kind == PLANAR ? 2 : joint->kind == CYLINDRICAL ? 1 : 0;
    return drive - (single || k < slides ? joint->damping : joint->spin_damping) * motion->v[j][k];
}

wide mechanism_spring(const mechanism *const m, const int j, const joint_motion *const motion)
{
    return -m->joint[j].stiffness * (motion->q[j][0] - m->joint[j].rest);
}

void mechanism_applied_force(const mechanism *const m, const body_motion moved[BODIES_MAX], const int n, wide point[3],
                             wide axis[3])
{
    const applied_force *const t = &m->applied_force[n];
    const pose *const b = &moved[t->body].body;
    wide e[3];
    unit(t->axis, e);
    part(jet3_add(b->origin, jet33_apply(&b->turn, jet3_constant(t->at))), 0, point);
    part(jet33_apply(&b->turn, jet3_constant(e)), 0, axis);
}

/* Adds a force at a point, and a moment, to what acts on a body about its centre of mass. */
static void push(wide load[PER_BODY], const body_motion *const b, const wide sign, const wide point[3],
                 const wide force[3], const wide moment[3])
{
    wide com[3];
    wide arm[3];
    wide about[3];
    part(b->com, 0, com);
    difference(point, com, arm);
    cross(arm, force, about);
    accumulate(load, sign, force);
    accumulate(load + ALPHA_AT, sign, about);
    accumulate(load + ALPHA_AT, sign, moment);
}

/* What drive, damping and spring of joint j put on its child at the hinge. */
static reaction joint_effort(const mechanism *const m, const int j, const body_motion moved[BODIES_MAX],
                             const joint_motion *const motion, const wide *const u)
{
    reaction r = {{0.0L}, {0.0L}};
    for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
        const wide effort = mechanism_effort(m, j, k, motion, u) + (k == 0 ? mechanism_spring(m, j, motion) : 0.0L);
        accumulate(r.force, effort, moved[j].slide[k]);
        accumulate(r.moment, effort, moved[j].turn[k]);
    }
    return r;
}

/* Weight, gyroscopic moment, efforts and applied forces on every body. */
static void all_loads(const mechanism *const m, const body_motion moved[BODIES_MAX], const joint_motion *const motion,
                      const wide *const u, wide load[BODIES_MAX][PER_BODY])
{
    memset(load, 0, BODIES_MAX * sizeof *load);
    for (int i = 0; i < m->bodies; i++) {
        wide omega[3];
        wide spin[3];
        wide gyroscopic[3];
        part(moved[i].omega, 0, omega);
        part(jet33_apply(&moved[i].inertia, moved[i].omega), 0, spin);
        cross(omega, spin, gyroscopic);
        accumulate(load[i], m->body[i].mass, m->gravity);
        accumulate(load[i] + ALPHA_AT, -1.0L, gyroscopic);

        const reaction r = joint_effort(m, i, moved, motion, u);
        push(load[i], &moved[i], 1.0L, moved[i].hinge, r.force, r.moment);
        if (m->joint[i].parent != GROUND) {
            push(load[m->joint[i].parent], &moved[m->joint[i].parent], -1.0L, moved[i].hinge, r.force, r.moment);
        }
    }
    for (int n = 0; n < m->applied_forces; n++) {
        const int b = m->applied_force[n].body;
        wide point[3];
        wide axis[3];
        mechanism_applied_force(m, moved, n, point, axis);
        const wide f = u[m->applied_force[n].input - 1];
        const wide moment = f * m->applied_force[n].lever;
        push(load[b], &moved[b], 1.0L, point, (const wide[3]){f * axis[0], f * axis[1], f * axis[2]},
             (const wide[3]){moment * axis[0], moment * axis[1], moment * axis[2]});
    }
}

static void add_bodies(linear_system *const s, const mechanism *const m, const body_motion moved[BODIES_MAX],
                       wide load[BODIES_MAX][PER_BODY])
{
    for (int i = 0; i < m->bodies; i++) {
        const int at = PER_BODY * i;
        for (int r = 0; r < 3; r++) {
            s->a[at + r][at + r] = m->body[i].mass;
            for (int c = 0; c < 3; c++) {
                s->a[at + ALPHA_AT + r][at + ALPHA_AT + c] = moved[i].inertia.m[r][c].c[0];
            }
        }
        for (int r = 0; r < PER_BODY; r++) {
            s->a[at + r][s->n] = load[i][r];
        }
    }
}

/* The rows of one hold from `row` on, times `part`, and their transpose as forces. */
static void add_hold(linear_system *const s, const hold *const h, const held *const made, const int row,
                     const wide part)
{
    for (int r = 0; r < made->rows; r++) {
        s->a[row + r][s->n] -= part * made->bias[r];
        for (int side = 0; side < 2; side++) {
            const int body = side == 0 ? h->parent : h->child;
            const wide *const factor = side == 0 ? made->of_parent[r] : made->of_child[r];
            for (int k = 0; k < PER_BODY && body != GROUND; k++) {
                s->a[row + r][PER_BODY * body + k] += part * factor[k];
                s->a[PER_BODY * body + k][row + r] -= part * factor[k];
            }
        }
    }
}

/* The second derivatives of two coordinates, or of one and the motion that it has. */
static void add_coupling(linear_system *const s, const mechanism *const m, const coupling *const c,
                         const joint_motion *const motion, const body_motion moved[BODIES_MAX], const int row)
{
    const hold first = hold_of_coordinate(m, c->first, motion->q[c->first][0]);
    const held made = hold_linearise(&first, moved);
    s->a[row][s->n] = -c->swing * c->omega * c->omega * sinl(c->omega * m->time + c->phase);
    add_hold(s, &first, &made, row, 1.0L);
    if (c->second != GROUND) {
        const hold second = hold_of_coordinate(m, c->second, motion->q[c->second][0]);
        const held other = hold_linearise(&second, moved);
        add_hold(s, &second, &other, row, -c->ratio);
    }
}

/* What the multipliers of a hold put on its child, at `point`. */
static reaction reaction_of(const held *const made, const wide *const lambda, const body_motion *const child,
                            const wide point[3])
{
    reaction out = {{0.0L}, {0.0L}};
    wide com[3];
    wide arm[3];
    wide about[3];
    for (int r = 0; r < made->rows; r++) {
        accumulate(out.force, lambda[r], made->of_child[r]);
        accumulate(out.moment, lambda[r], made->of_child[r] + ALPHA_AT);
    }
    part(child->com, 0, com);
    difference(point, com, arm);
    cross(arm, out.force, about);
    accumulate(out.moment, -1.0L, about);
    return out;
}

/* Accelerations of the joints from those of the bodies. With that of joint i still zero, what body i lacks is the sum
 * of its speeds' directions, which are square to each other, times their rates. */
static void find_joint_accelerations(const mechanism *const m, const joint_motion *const motion, const wide *const x,
                                     solution *const out)
{
    joint_motion found = *motion;
    body_motion moved[BODIES_MAX];
    memset(found.a, 0, sizeof found.a);
    for (int i = 0; i < m->bodies; i++) {
        wide linear[3];
        wide angular[3];
        wide com[3];
        wide arm[3];
        mechanism_move_body(m, &found, i, moved);
        const body_motion *const b = &moved[i];
        part(b->com, 0, com);
        difference(com, b->hinge, arm);
        for (int c = 0; c < 3; c++) {
            linear[c] = x[PER_BODY * i + c] - 2.0L * b->com.x[c].c[2];
            angular[c] = x[PER_BODY * i + ALPHA_AT + c] - b->omega.x[c].c[1];
        }
        for (int k = joint_speeds(m->joint[i].kind) - 1; k >= 0; k--) {
            const bool turns = dot(b->turn[k], b->turn[k]) > 0.0L;
            const wide rate = turns ? dot(b->turn[k], angular) : dot(b->slide[k], linear);
            wide swung[3];
            cross(b->turn[k], arm, swung);
            accumulate(linear, -rate, swung);
            accumulate(linear, -rate, b->slide[k]);
            found.a[i][k] = rate;
        }
        mechanism_move_body(m, &found, i, moved);
    }
    memcpy(out->a, found.a, sizeof out->a);
}

/* All holds at a motion: of the joints, then of the closures. */
typedef struct all_holds {
    int count, rows;
    hold hold[BODIES_MAX + CLOSURES_MAX];
    held made[BODIES_MAX + CLOSURES_MAX];
} all_holds;

static void linearise(const mechanism *const m, const body_motion moved[BODIES_MAX], all_holds *const all)
{
    all->count = m->bodies + m->closures;
    all->rows = 0;
    for (int n = 0; n < all->count; n++) {
        all->hold[n] = n < m->bodies ? hold_of_joint(m, n) : hold_of_closure(m, n - m->bodies);
        all->made[n] = hold_linearise(&all->hold[n], moved);
        all->rows += all->made[n].rows;
    }
}

static void find_reactions(const mechanism *const m, const all_holds *const all, const body_motion moved[BODIES_MAX],
                           const joint_motion *const motion, const wide *const u, const wide *lambda,
                           solution *const out)
{
    for (int n = 0; n < all->count; n++) {
        const int child = all->hold[n].child;
        wide point[3];
        part(frame_on(pose_of(moved, child), &all->hold[n].on_child).origin, 0, point);
        reaction *const to = n < m->bodies ? &out->joint[n] : &out->closure[n - m->bodies];
        *to = reaction_of(&all->made[n], lambda, &moved[child], point);
        lambda += all->made[n].rows;
    }
    for (int j = 0; j < m->bodies; j++) {
        const reaction effort = joint_effort(m, j, moved, motion, u);
        accumulate(out->joint[j].force, 1.0L, effort.force);
        accumulate(out->joint[j].moment, 1.0L, effort.moment);
    }
    for (int n = 0; n < m->couplings; n++) {
        const int of[2] = {m->coupling[n].first, m->coupling[n].second};
        out->coupling[n] = lambda[n];
        for (int i = 0; i < 2 && of[i] != GROUND; i++) {
            const wide effort = i == 0 ? lambda[n] : -m->coupling[n].ratio * lambda[n];
            accumulate(out->joint[of[i]].force, effort, moved[of[i]].slide[0]);
            accumulate(out->joint[of[i]].moment, effort, moved[of[i]].turn[0]);
        }
    }
}

bool mechanism_solve(const mechanism *const m, const joint_motion *const motion, const wide *const u,
                     solution *const out)
{
    static linear_system s;
    static all_holds all;
    wide x[UNKNOWNS_MAX];
    wide load[BODIES_MAX][PER_BODY];
    body_motion moved[BODIES_MAX];
    mechanism_move(m, motion, moved);
    linearise(m, moved, &all);
    memset(&s, 0, sizeof s);
    s.n = PER_BODY * m->bodies + all.rows + m->couplings;
    if (s.n > UNKNOWNS_MAX) {
        return false;
    }
    all_loads(m, moved, motion, u, load);
    add_bodies(&s, m, moved, load);
    int row = PER_BODY * m->bodies;
    for (int n = 0; n < all.count; n++) {
        add_hold(&s, &all.hold[n], &all.made[n], row, 1.0L);
        row += all.made[n].rows;
    }
    for (int n = 0; n < m->couplings; n++) {
        add_coupling(&s, m, &m->coupling[n], motion, moved, row + n);
    }
    if (!linear_solve(&s, LEAST_PIVOT, x)) {
        return false;
    }
    memset(out, 0, sizeof *out);
    for (int i = 0; i < m->bodies; i++) {
        memcpy(out->acceleration[i], x + PER_BODY * i, sizeof out->acceleration[i]);
    }
    find_reactions(m, &all, moved, motion, u, x + PER_BODY * m->bodies, out);
    find_joint_accelerations(m, motion, x, out);
    return true;
}
