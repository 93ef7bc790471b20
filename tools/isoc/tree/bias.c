#include "tools/isoc/tree/tree.h"

/* The acceleration of a point of a segment, or of the ground, in its axes. */
static vector point_acceleration(const kinematics *k, const acceleration *all, int i, vector point)
{
    graph *g = k->g;
    if (i == GROUND) {
        return vector_sub(g, vector_zero(g), k->m->forces.gravity);
    }
    return vector_add(g, all[i].a, swing(g, k->motions[i].omega, all[i].alpha, point));
}

acceleration joint_coriolis(const kinematics *k, int i)
{
    graph *g = k->g;
    const motion *now = &k->motions[i];
    const vector turned = vector_cross(g, now->carried, now->rate);
    const vector alpha = turn_of(k, i, turned);
    return (acceleration){alpha, vector_scale(g, constant(g, 2.0), slide_of(k, i, turned))};
}

acceleration accelerate_outward(const kinematics *k, int i, const acceleration *all)
{
    graph *g = k->g;
    const segment *l = &k->m->segments[i];
    const motion *now = &k->motions[i];
    acceleration result;
    result.alpha = l->parent == GROUND ? vector_zero(g) : from_parent(k, i, all[l->parent].alpha);
    result.a = from_parent(k, i, point_acceleration(k, all, l->parent, now->p));
    const acceleration coriolis = joint_coriolis(k, i);
    result.alpha = vector_add(g, result.alpha, coriolis.alpha);
    result.a = vector_add(g, result.a, coriolis.a);
    vector_name(g, result.alpha, "alpha", l->name);
    vector_name(g, result.a, "a", l->name);
    return result;
}

void inertial_wrenches(const kinematics *k, const acceleration *accelerations, wrench *wrenches)
{
    const mechanism *m = k->m;
    for (int i = 0; i < m->segment_count; i++) {
        wrenches[i] = wrench_of_motion(k->g, m->segments[i].own, k->motions[i].omega, accelerations[i]);
    }
    FOR_ALL (const applied_force, f, m->forces.applied, m->forces.applied_count) {
        wrenches[f->segment] = wrench_sub(k->g, wrenches[f->segment], wrench_of_applied_force(k->g, f));
    }
}

void efforts_of_wrenches(const kinematics *k, wrench *wrenches, node *efforts)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    vector *felt =
        arena_take(g->memory, (size_t)m->segment_count, sizeof *felt); /* moments by which segments are turned */
    for (int i = 0; i < m->segment_count; i++) {
        felt[i] = wrenches[i].moment;
    }
    for (int i = m->segment_count - 1; i >= 0; i--) {
        const segment *l = &m->segments[i];
        vector_name(g, wrenches[i].force, "force", l->name);
        vector_name(g, wrenches[i].moment, "moment", l->name);
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            const node along = component_along(k, f, (wrench){wrenches[i].force, felt[i]});
            efforts[f] = graph_name(g, along, "bias_%s", m->dofs[f].name);
        }
        if (l->parent != GROUND) {
            wrench turning = wrenches[i]; /* without the moment about a shared axis */
            wrenches[l->parent] = wrench_add(g, wrenches[l->parent], wrench_to_parent(k, i, wrenches[i]));
            turning.moment.at[l->axis] = shared_axis(k, i) != 0 ? constant(g, 0.0) : turning.moment.at[l->axis];
            felt[l->parent] = vector_add(g, felt[l->parent], wrench_to_parent(k, i, turning).moment);
        }
    }
}

void bias_build(const kinematics *k, node *bias, acceleration *accelerations)
{
    graph *g = k->g;
    const mechanism *m = k->m;
    wrench *wrenches = arena_take(g->memory, (size_t)m->segment_count, sizeof *wrenches);
    graph_section(g, "Accelerations outward, at q'' = 0 and with the ground accelerated by -gravity (Newton-Euler)");
    for (int i = 0; i < m->segment_count; i++) {
        accelerations[i] = accelerate_outward(k, i, accelerations);
    }
    graph_section(g, "Forces and moments inward: what q'' = 0 would take (bias)");
    inertial_wrenches(k, accelerations, wrenches);
    efforts_of_wrenches(k, wrenches, bias);
}
