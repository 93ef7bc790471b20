#include "tools/isoc/bias.h"

vector point_acceleration(const kinematics *k, const acceleration *all, int i, vector point)
{
    graph *g = k->g;
    if (i == GROUND) {
        return vector_sub(g, vector_zero(g), k->m->gravity);
    }
    return vector_add(g, all[i].a, swing(g, k->motions[i].omega, all[i].alpha, point));
}

acceleration joint_coriolis(const kinematics *k, int i)
{
    graph *g = k->g;
    const motion *now = &k->motions[i];
    const vector turned = vector_cross(g, now->carried, now->rate), zero = vector_zero(g);
    return slides(&k->m->links[i]) ? (acceleration){zero, vector_scale(g, constant(g, 2.0), turned)}
                                   : (acceleration){turned, zero};
}

acceleration accelerate_outward(const kinematics *k, int i, const acceleration *all)
{
    graph *g = k->g;
    const link *l = &k->m->links[i];
    const motion *now = &k->motions[i];
    acceleration made;
    made.alpha = l->parent == GROUND ? vector_zero(g) : from_parent(k, i, all[l->parent].alpha);
    made.a = from_parent(k, i, point_acceleration(k, all, l->parent, now->p));
    const acceleration coriolis = joint_coriolis(k, i);
    made.alpha = vector_add(g, made.alpha, coriolis.alpha);
    made.a = vector_add(g, made.a, coriolis.a);
    vector_name(g, made.alpha, "alpha", l->name);
    vector_name(g, made.a, "a", l->name);
    return made;
}

/* Newton and Euler about the link's origin: F = m a + swing(ms), N = J alpha + omega x J omega + ms x a. */
static wrench inertial_wrench(const kinematics *k, int i, acceleration now)
{
    graph *g = k->g;
    const link *l = &k->m->links[i];
    const vector w = k->motions[i].omega;
    wrench made;
    made.force = vector_scale(g, l->mass, now.a);
    made.force = vector_add(g, made.force, swing(g, w, now.alpha, l->first_moment));
    const vector gyroscopic = vector_cross(g, w, tensor_apply(g, l->inertia, w));
    const vector angular = vector_add(g, tensor_apply(g, l->inertia, now.alpha), gyroscopic);
    made.moment = vector_add(g, angular, vector_cross(g, l->first_moment, now.a));
    return made;
}

/* Takes off what a force on a body gives: u e at its point, with a moment about its own line. */
static void push(const kinematics *k, const thrust *t, wrench *w)
{
    graph *g = k->g;
    const vector force = vector_scale(g, leaf(g, OP_INPUT, t->drive), t->axis);
    const vector swung = vector_cross(g, t->point, force);
    const vector about = vector_add(g, swung, vector_scale(g, t->lever, force));
    w->force = vector_sub(g, w->force, force);
    w->moment = vector_sub(g, w->moment, about);
}

void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches)
{
    const mechanism *m = k->m;
    for (int i = 0; i < m->link_count; i++) {
        wrenches[i] = inertial_wrench(k, i, accelerations[i]);
    }
    for (int i = 0; i < m->thrust_count; i++) {
        push(k, &m->thrusts[i], &wrenches[m->thrusts[i].link]);
    }
}

static wrench wrench_to_parent(const kinematics *k, int i, wrench w)
{
    wrench made;
    made.force = to_parent(k, i, w.force);
    made.moment = to_parent(k, i, w.moment);
    made.moment = vector_add(k->g, made.moment, vector_cross(k->g, k->motions[i].p, made.force));
    return made;
}

void bias_build(const kinematics *k, node *bias, acceleration *accelerations)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    wrench *wrenches = arena_take(g->memory, (size_t)m->link_count, sizeof *wrenches);
    graph_section(g, "Accelerations outward, at q'' = 0 and with the ground accelerated by -gravity (Newton-Euler)");
    for (int i = 0; i < m->link_count; i++) {
        accelerations[i] = accelerate_outward(k, i, accelerations);
    }
    graph_section(g, "Forces and moments inward: what q'' = 0 would take (bias)");
    inertial_wrenches(k, accelerations, wrenches);
    for (int i = m->link_count - 1; i >= 0; i--) {
        const link *l = &m->links[i];
        vector_name(g, wrenches[i].force, "force", l->name);
        vector_name(g, wrenches[i].moment, "moment", l->name);
        for (int f = l->freedom; f < l->freedom + freedoms_of(l->kind); f++) {
            const node along = vector_dot(g, axis_of(k, f), slides(l) ? wrenches[i].force : wrenches[i].moment);
            bias[f] = graph_name(g, along, "bias_%s", m->freedoms[f].name);
        }
        if (l->parent != GROUND) {
            const wrench w = wrench_to_parent(k, i, wrenches[i]);
            wrench *parent = &wrenches[l->parent];
            parent->force = vector_add(g, parent->force, w.force);
            parent->moment = vector_add(g, parent->moment, w.moment);
        }
    }
}
