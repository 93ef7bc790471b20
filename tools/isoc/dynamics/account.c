#include "tools/isoc/dynamics/dynamics.h"

/* T = m v.v / 2 + v.(omega x ms) + omega.J omega / 2, about the segment's origin, and of its armature; and its
 * spring's. */
static node energy_of_segment(const dynamics *d, int i)
{
    graph *g = d->g;
    const node half = constant(g, 0.5);
    const segment *l = &d->m->segments[i];
    const motion *now = &d->k.motions[i];
    const node half_mass = mul(g, half, l->own.mass);
    const node linear = mul(g, half_mass, vector_dot(g, now->v, now->v));
    const node mixed = vector_dot(g, now->v, vector_cross(g, now->omega, l->own.ms));
    const node angular = mul(g, half, vector_dot(g, now->omega, tensor_apply(g, l->own.inertia, now->omega)));
    const node stretch = sub(g, now->q[0], l->rest);
    const node half_spring = mul(g, half, l->spring);
    node square = mul(g, now->qd[0], now->qd[0]);
    for (int n = 1; n < dofs_of(l->kind); n++) {
        square = add(g, square, mul(g, now->qd[n], now->qd[n]));
    }
    const node rotor = mul(g, mul(g, half, l->armature), square);
    const node kinetic = add(g, add(g, add(g, linear, mixed), angular), rotor);
    return add(g, kinetic, mul(g, half_spring, mul(g, stretch, stretch)));
}

node account_motion(const dynamics *d)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    node sum = constant(g, 0.0);
    for (int i = 0; i < m->segment_count; i++) {
        sum = add(g, sum, energy_of_segment(d, i));
    }
    for (int i = 0; i < m->forces.spring_count; i++) {
        sum = add(g, sum, spring_energy(g, &m->forces.springs[i], &d->springs[i]));
    }
    return sum;
}

node account_energy(const dynamics *d)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    graph_section(g, "Energy: kinetic, of gravity, of springs");
    const node kinetic = account_motion(d);
    node stored = constant(g, 0.0);
    for (int i = 0; i < m->effects.count; i++) {
        stored = add(g, stored, m->effects.accounts[i].stored);
    }
    /* V = -g . (the first moment of everything about the ground's origin) */
    const composite all = composite_of_all(&d->k);
    return add(g, sub(g, kinetic, vector_dot(g, m->forces.gravity, all.ms)), stored);
}

energy_course account_course(const dynamics *d)
{
    const graph *g = d->g;
    const mechanism *m = d->m;
    bool is_known = !m->bodies.vary && m->clocks.count == 0 && m->parameters.change_count == 0 && !has_events(m),
         falls = false;
    FOR_ALL (const segment, l, m->segments, m->segment_count) {
        is_known = is_known && l->drive < 0;
        falls = falls || !is_zero(g, l->damping);
    }
    FOR_ALL (const point_spring, p, m->forces.springs, m->forces.spring_count) {
        falls = falls || !is_zero(g, p->damping);
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        is_known = is_known && f->drive < 0;
    }
    FOR_ALL (const closure, c, m->closures, m->closure_count) {
        is_known = is_known && c->kind != CLOSE_MOTION;
    }
    FOR_ALL (const effect_account, e, m->effects.accounts, m->effects.count) {
        is_known = is_known && is_zero(g, e->power) && is_zero(g, e->stored);
    }
    return !is_known ? ENERGY_UNKNOWN : falls ? ENERGY_FALLS : ENERGY_STAYS;
}

/* The derivative of a node by time in the motion. */
static node rate_of(const dynamics *d, node n)
{
    const int states = state_count(d->m);
    node *along = arena_take(d->g->memory, (size_t)states, sizeof *along), rate;
    for (int i = 0; i < states; i++) {
        along[i] = leaf(d->g, OP_DERIVATIVE, i);
    }
    differentiate_along(d->g, &n, 1, along, NULL, &rate);
    return rate;
}

/* What masses that come and go bring: the rate of the energy of the mechanism with them alone. */
static node power_of_masses(const dynamics *d)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    const int states = state_count(m), first = m->effects.first_state;
    const node of_gravity = vector_dot(g, m->forces.gravity, composite_of_all(&d->k).ms);
    const node energy = sub(g, account_motion(d), of_gravity);
    node *along = arena_take(g->memory, (size_t)states, sizeof *along), rate;
    for (int i = 0; i < states; i++) {
        const bool is_of_effect = i >= first && i < first + m->effects.state_count;
        along[i] = is_of_effect ? leaf(g, OP_DERIVATIVE, i) : constant(g, 0.0);
    }
    differentiate_along(g, &energy, 1, along, NULL, &rate);
    return rate;
}

/* The power of the input and of the damping of a degree of freedom. */
static node power_of_joint(const dynamics *d, int f)
{
    graph *g = d->g;
    const segment *l = &d->m->segments[d->m->dofs[f].segment];
    const node speed = d->k.motions[d->m->dofs[f].segment].qd[f - l->dof];
    const node drive = l->drive < 0 ? constant(g, 0.0) : leaf(g, OP_INPUT, l->drive);
    return mul(g, sub(g, drive, mul(g, l->damping, speed)), speed);
}

/* The power of a force of an input. */
static node power_of_force(const dynamics *d, const applied_force *f)
{
    graph *g = d->g;
    const vector force = vector_scale(g, leaf(g, OP_INPUT, f->drive), f->axis);
    const vector moment = vector_scale(g, f->lever, force);
    const node linear = vector_dot(g, force, point_velocity(&d->k, f->segment, f->point));
    return add(g, linear, vector_dot(g, moment, d->k.motions[f->segment].omega));
}

static node power_of_constraint(const dynamics *d, int r)
{
    graph *g = d->g;
    node rate = constant(g, 0.0);
    for (int f = 0; f < d->m->dof_count; f++) {
        const node speed = leaf(g, OP_STATE, d->m->position_count + f);
        rate = add(g, rate, mul(g, d->loops.phi.all[r].row[f], speed));
    }
    return neg(g, mul(g, d->loops.multipliers[r], rate));
}

static node power_of_effect(const dynamics *d, const effect_account *e)
{
    graph *g = d->g;
    return e->is_told ? sub(g, e->work, e->loss) : add(g, e->power, rate_of(d, e->stored));
}

/* Of a hold of the scene while it slips; those of effects are in their accounts. */
static node power_of_hold(const dynamics *d, const held_speed *h)
{
    graph *g = d->g;
    node speed = leaf(g, OP_STATE, d->m->position_count + h->dof);
    if (h->against >= 0) {
        speed = sub(g, speed, leaf(g, OP_STATE, d->m->position_count + h->against));
    }
    const node effort = mul(g, leaf(g, OP_STATE, h->state), h->sliding);
    return neg(g, mul(g, effort, speed));
}

node account_power(const dynamics *d)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    node sum = constant(g, 0.0);
    graph_section(g, "Power of inputs, dampers, closures and effects");
    for (int f = 0; f < m->dof_count; f++) {
        sum = add(g, sum, power_of_joint(d, f));
    }
    for (int i = 0; i < m->forces.spring_count; i++) {
        const node rate = d->springs[i].rate;
        sum = sub(g, sum, mul(g, mul(g, m->forces.springs[i].damping, rate), rate));
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        if (m->forces.applied[i].drive >= 0) {
            sum = add(g, sum, power_of_force(d, &m->forces.applied[i]));
        }
    }
    for (int r = 0; r < d->loops.phi.count; r++) {
        sum = add(g, sum, power_of_constraint(d, r));
    }
    for (int i = 0; i < m->effects.count; i++) {
        sum = add(g, sum, power_of_effect(d, &m->effects.accounts[i]));
    }
    sum = m->bodies.vary ? add(g, sum, power_of_masses(d)) : sum;
    FOR_ALL (const held_speed, h, m->events.holds, m->events.hold_count) {
        sum = h->effect < 0 ? add(g, sum, power_of_hold(d, h)) : sum;
    }
    return sum;
}

node account_balance(const dynamics *d)
{
    const node rate = rate_of(d, account_energy(d));
    return sub(d->g, rate, account_power(d));
}
