#include "tools/isoc/dynamics/dynamics.h"

acceleration *reaction_accelerations(const dynamics *d)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    acceleration *result = arena_take(g->memory, (size_t)m->segment_count, sizeof *result);
    graph_section(g, "Accelerations of the links, for reactions");
    for (int i = 0; i < m->segment_count; i++) {
        const segment *l = &m->segments[i];
        result[i] = accelerate_outward(&d->k, i, result);
        for (int f = l->dof; f < l->dof + dofs_of(l->kind); f++) {
            const node qdd = leaf(g, OP_DERIVATIVE, m->position_count + f);
            const vector moved = vector_scale(g, qdd, axis_of(&d->k, f));
            result[i].alpha = vector_add(g, result[i].alpha, turn_of(&d->k, i, moved));
            result[i].a = vector_add(g, result[i].a, slide_of(&d->k, i, moved));
        }
    }
    return result;
}

/* The reaction of a closure on the child, in base axes. */
static wrench closure_in_base(const dynamics *d, int index)
{
    graph *g = d->g;
    const augmented *loops = &d->loops;
    wrench sum = {vector_zero(g), vector_zero(g)};
    for (int r = 0; r < loops->phi.count; r++) {
        const constraint *c = &loops->phi.all[r];
        if (c->closure == index) {
            sum.force = vector_add(g, sum.force, vector_scale(g, loops->multipliers[r], c->force));
            sum.moment = vector_add(g, sum.moment, vector_scale(g, loops->multipliers[r], c->moment));
        }
    }
    return sum;
}

static vector inward_point(const kinematics *k, int base, int i, vector point)
{
    if (i == base) {
        return point;
    }
    const vector on_parent = inward_point(k, base, k->m->segments[i].parent, point);
    return from_parent(k, i, vector_sub(k->g, on_parent, k->motions[i].p));
}

/* The wrench of a closure on the child, at the child's point, in the frame of a side's segment; on the parent it is the
 * opposite, at the same point. */
static wrench closure_on_segment(const dynamics *d, int index, int i)
{
    const closure *c = &d->m->closures[index];
    const wrench in_base = closure_in_base(d, index);
    const vector in_base_point = outward_point(&d->k, c->child.segment, c->base, c->child.point);
    const vector point = i == c->child.segment ? c->child.point : inward_point(&d->k, c->base, i, in_base_point);
    const vector force = inward_axes(&d->k, c->base, i, in_base.force);
    return wrench_at(d->g, point, force, inward_axes(&d->k, c->base, i, in_base.moment));
}

/* The wrench of a spring on a body at an end of it, in the frame of the body's segment. */
static wrench spring_on_body(const dynamics *d, int index, int which)
{
    graph *g = d->g;
    const point_spring *s = &d->m->forces.springs[index];
    const bool is_second = s->second.body == which;
    const closure_end *end = is_second ? &s->second : &s->first;
    const vector on_second = spring_force(g, &d->springs[index]);
    const vector force = is_second ? on_second : vector_sub(g, vector_zero(g), on_second);
    return wrench_at(g, end->point, inward_axes(&d->k, s->base, end->segment, force), vector_zero(g));
}

/* The wrench on a body without that of its joint, its weight and its children, in its segment's frame. */
static wrench acting(const dynamics *d, int index)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    wrench sum = {vector_zero(g), vector_zero(g)};
    for (int i = 0; i < m->forces.applied_count; i++) {
        if (m->forces.applied[i].body == index) {
            sum = wrench_add(g, sum, wrench_of_applied_force(g, &m->forces.applied[i]));
        }
    }
    for (int i = 0; i < m->forces.spring_count; i++) {
        if (m->forces.springs[i].second.body == index || m->forces.springs[i].first.body == index) {
            sum = wrench_add(g, sum, spring_on_body(d, i, index));
        }
    }
    for (int i = 0; i < m->closure_count; i++) {
        const closure *c = &m->closures[i];
        if (acts_along_joints(c->kind)) {
            continue;
        }
        if (c->child.body == index) {
            sum = wrench_add(g, sum, closure_on_segment(d, i, c->child.segment));
        }
        if (c->parent.body == index) {
            sum = wrench_sub(g, sum, closure_on_segment(d, i, c->parent.segment));
        }
    }
    return sum;
}

/* The wrench that a joint transmits to its child, in the child's segment's frame: for the child and all its
 * descendants.
 */
static wrench borne(const dynamics *d, const acceleration *accelerations, int index)
{
    graph *g = d->g;
    const mechanism *m = d->m;
    const int on = m->bodies.frames[index].segment;
    const vector zero = vector_zero(g);
    const acceleration resting = {zero, vector_sub(g, zero, m->forces.gravity)};
    const vector omega = on == GROUND ? zero : d->k.motions[on].omega;
    wrench sum = wrench_of_motion(g, m->bodies.members[index].own, omega, on == GROUND ? resting : accelerations[on]);
    sum = wrench_sub(g, sum, acting(d, index));
    for (int child = 0; child < m->bodies.count; child++) {
        if (m->bodies.members[child].parent == index) {
            wrench w = borne(d, accelerations, child);
            for (int i = m->bodies.frames[child].segment; i != on; i = m->segments[i].parent) {
                w = wrench_to_parent(&d->k, i, w);
            }
            sum = wrench_add(g, sum, w);
        }
    }
    return sum;
}

static wrench to_ground(const dynamics *d, int i, wrench w)
{
    const vector force = outward_axes(&d->k, i, GROUND, w.force);
    return (wrench){force, outward_axes(&d->k, i, GROUND, w.moment)};
}

wrench joint_reaction(const dynamics *d, const acceleration *accelerations, int index)
{
    graph *g = d->g;
    const member *child = &d->m->bodies.members[index];
    wrench w = borne(d, accelerations, index);
    w.moment = vector_sub(g, w.moment, vector_cross(g, child->hinge, w.force));
    vector_name(g, w.force, "reaction", child->joint);
    vector_name(g, w.moment, "reaction_moment", child->joint);
    return to_ground(d, d->m->bodies.frames[index].segment, w);
}

wrench closure_reaction(const dynamics *d, int index)
{
    return to_ground(d, d->m->closures[index].base, closure_in_base(d, index));
}

node closure_effort(const dynamics *d, int index)
{
    node effort = constant(d->g, 0.0);
    for (int r = 0; r < d->loops.phi.count; r++) {
        effort = d->loops.phi.all[r].closure == index ? neg(d->g, d->loops.multipliers[r]) : effort;
    }
    return graph_name(d->g, effort, "effort_%s", d->m->closures[index].name);
}
