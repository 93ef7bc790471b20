#include "tests/isoc/dynamics/balance.h"

#include "tests/isoc/dynamics/wide3.h"

/* The relative size of a sum that should be zero. */
typedef struct balance {
    wide sum;
    wide size;
} balance;

static void balance_add(balance *const b, const wide term)
{
    b->sum += term;
    b->size += fabsl(term);
}

/* Force, and moment about the world's origin. */
typedef struct wrench {
    wide force[3];
    wide moment[3];
} wrench;

static void wrench_add(wrench *const w, const wide sign, const wide point[3], const wide force[3], const wide moment[3])
{
    wide about[3];
    cross(point, force, about);
    accumulate(w->force, sign, force);
    accumulate(w->moment, sign, about);
    accumulate(w->moment, sign, moment);
}

static wrench applied_force_wrench(const mechanism *const m, const sample *const s, const body_motion moved[BODIES_MAX],
                                   const int n)
{
    wrench w = {{0.0L}, {0.0L}};
    wide point[3];
    wide axis[3];
    wide moment[3] = {0.0L, 0.0L, 0.0L};
    wide force[3] = {0.0L, 0.0L, 0.0L};
    mechanism_applied_force(m, moved, n, point, axis);
    const wide f = s->input[m->applied_force[n].input - 1];
    accumulate(force, f, axis);
    accumulate(moment, f * m->applied_force[n].lever, axis);
    wrench_add(&w, 1.0L, point, force, moment);
    return w;
}

/* What acts from without on all that hangs on `root`, but for weight and root's joint: applied forces, and closures as
 * the independent solver has them. */
static wrench outside(const mechanism *const m, const sample *const s, const body_motion moved[BODIES_MAX],
                      const int root)
{
    wrench w = {{0.0L}, {0.0L}};
    const wide origin[3] = {0.0L, 0.0L, 0.0L};
    for (int n = 0; n < m->applied_forces; n++) {
        if (mechanism_carries(m, root, m->applied_force[n].body)) {
            const wrench t = applied_force_wrench(m, s, moved, n);
            wrench_add(&w, 1.0L, origin, t.force, t.moment);
        }
    }
    for (int n = 0; n < m->closures; n++) {
        const loop_closure *const c = &m->closure[n];
        wide point[3];
        part(frame_on(pose_of(moved, c->child), &c->on_child).origin, 0, point);
        const wide sign = (mechanism_carries(m, root, c->child) ? 1.0L : 0.0L) -
                          (mechanism_carries(m, root, c->parent) ? 1.0L : 0.0L);
        wrench_add(&w, sign, point, s->exact.closure[n].force, s->exact.closure[n].moment);
    }
    return w;
}

/* E is the independent energy along the plant's motion; its size is that of the energies that flow: m v.a of every
 * body. */
static wide energy_balance(const mechanism *const m, const sample *const s)
{
    body_motion moved[BODIES_MAX];
    mechanism_move(m, &s->motion, moved);
    balance b = {0};
    balance_add(&b, mechanism_energy(m, &s->motion, moved).c[1]);
    for (int j = 0; j < m->bodies; j++) {
        for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
            balance_add(&b, -mechanism_effort(m, j, k, &s->motion, s->input) * s->motion.v[j][k]);
        }
    }
    for (int n = 0; n < m->applied_forces; n++) {
        const wrench w = applied_force_wrench(m, s, moved, n);
        const body_motion *const on = &moved[m->applied_force[n].body];
        wide omega[3];
        wide velocity[3];
        wide com[3];
        wide about[3];
        part(on->omega, 0, omega);
        part(on->velocity, 0, velocity);
        part(on->com, 0, com);
        cross(com, w.force, about);
        balance_add(&b, -dot(w.force, velocity) - dot(w.moment, omega) + dot(about, omega));
    }
    for (int i = 0; i < m->bodies; i++) {
        for (int c = 0; c < 3; c++) {
            b.size += m->body[i].mass * fabsl(jet_mul(moved[i].velocity.x[c], moved[i].velocity.x[c]).c[1]);
        }
    }
    return fabsl(b.sum) / b.size;
}

/* Along speed k of joint j, all that hangs on it: turning, dL/dt about the hinge = moment from without + effort;
 * sliding, dp/dt = force from without + effort. No reaction of the joint enters. The size is that of the whole vectors.
 */
static wide momentum_balance(const mechanism *const m, const sample *const s, const body_motion moved[BODIES_MAX],
                             const int j, const int k)
{
    wide weight[3];
    wide weight_moment[3];
    wide rate[3];
    wide moment_rate[3];
    wide about[3];
    const momentum sum = mechanism_momentum(m, moved, j, weight, weight_moment);
    const wrench without = outside(m, s, moved, j);
    const wide *const p = moved[j].hinge;
    const bool turns = dot(moved[j].turn[k], moved[j].turn[k]) > 0.0L;
    const wide *const e = turns ? moved[j].turn[k] : moved[j].slide[k];
    balance b = {0};
    balance_add(&b, -mechanism_effort(m, j, k, &s->motion, s->input));
    balance_add(&b, k == 0 ? -mechanism_spring(m, j, &s->motion) : 0.0L);
    part(sum.linear, 1, rate);
    part(sum.angular, 1, moment_rate);
    accumulate(weight, 1.0L, without.force);
    accumulate(weight_moment, 1.0L, without.moment);
    cross(p, rate, about);
    accumulate(moment_rate, -1.0L, about);
    cross(p, weight, about);
    accumulate(weight_moment, -1.0L, about);
    const wide *const gained = turns ? moment_rate : rate;
    const wide *const given = turns ? weight_moment : weight;
    b.sum += dot(e, gained) - dot(e, given);
    b.size += sqrtl(dot(gained, gained)) + sqrtl(dot(given, given));
    return fabsl(b.sum) / b.size;
}

/* Of all that hangs on root's joint, or of all for GROUND: dp/dt = weight + forces from without and of that joint, or
 * of the joints with the ground, dL/dt about the origin = their moments; reactions from s->exact, momentum from the
 * motion. */
static wide reaction_balance(const mechanism *const m, const sample *const s, const body_motion moved[BODIES_MAX],
                             const int root)
{
    wide weight[3];
    wide weight_moment[3];
    const momentum sum = mechanism_momentum(m, moved, root, weight, weight_moment);
    wrench all = outside(m, s, moved, root);
    accumulate(all.force, 1.0L, weight);
    accumulate(all.moment, 1.0L, weight_moment);
    for (int j = 0; j < m->bodies; j++) {
        if (root == GROUND ? m->joint[j].parent == GROUND : j == root) {
            wrench_add(&all, 1.0L, moved[j].hinge, s->exact.joint[j].force, s->exact.joint[j].moment);
        }
    }
    wide force_size = 0.0L;
    wide moment_size = 0.0L;
    wide worst_force = 0.0L;
    wide worst_moment = 0.0L;
    for (int i = 0; i < 3; i++) {
        worst_force = fmaxl(worst_force, fabsl(sum.linear.x[i].c[1] - all.force[i]));
        worst_moment = fmaxl(worst_moment, fabsl(sum.angular.x[i].c[1] - all.moment[i]));
        force_size += fabsl(sum.linear.x[i].c[1]) + fabsl(weight[i]) + fabsl(all.force[i]);
        moment_size += fabsl(sum.angular.x[i].c[1]) + fabsl(weight_moment[i]) + fabsl(all.moment[i]);
    }
    return fmaxl(force_size > 0.0L ? worst_force / force_size : worst_force,
                 moment_size > 0.0L ? worst_moment / moment_size : worst_moment);
}

balances balances_of(const sample s[STATES], const wide off)
{
    const mechanism *const m = &the_table.mechanism;
    balances worst = {0};
    for (int n = 0; n < STATES; n++) {
        sample one = s[n];
        body_motion moved[BODIES_MAX];
        for (int j = 0; j < m->bodies; j++) {
            for (int k = 0; k < SPEEDS_MAX; k++) {
                one.motion.a[j][k] *= 1.0L + off;
            }
        }
        mechanism_move(m, &one.motion, moved);
        worst.energy = fmaxl(worst.energy, energy_balance(m, &one) / one.condition);
        worst.ground = fmaxl(worst.ground, reaction_balance(m, &one, moved, GROUND) / one.condition);
        for (int j = 0; j < m->bodies; j++) {
            for (int k = 0; k < joint_speeds(m->joint[j].kind); k++) {
                worst.dof = fmaxl(worst.dof, momentum_balance(m, &one, moved, j, k) / one.condition);
            }
        }
    }
    return worst;
}

wide balance_of_reactions(const sample *const s)
{
    const mechanism *const m = &the_table.mechanism;
    body_motion moved[BODIES_MAX];
    wide worst = 0.0L;
    mechanism_move(m, &s->motion, moved);
    for (int j = 0; j < m->bodies; j++) {
        worst = fmaxl(worst, reaction_balance(m, s, moved, j));
    }
    return worst / s->condition;
}
