#include "tools/isoc/stability/causes.h"

#include <string.h>

/* Effects, then joints, springs, and the stabilisation. */
int cause_count(const mechanism *m)
{
    return m->effect_count + m->segment_count + m->point_spring_count + (m->closure_count > 0);
}

cause cause_of(const mechanism *m, int which)
{
    const int at_joint = which - m->effect_count, spring = at_joint - m->segment_count;
    if (at_joint < 0) {
        return (cause){"effect", m->effects[which].text, m->effects[which].at};
    }
    if (spring < 0) {
        return (cause){"spring and damping of the joint", m->segments[at_joint].name, m->segments[at_joint].at};
    }
    if (spring < m->point_spring_count) {
        return (cause){"spring", m->point_springs[spring].name, m->point_springs[spring].at};
    }
    return (cause){"stabilisation of the closure", m->closures[0].name, m->closures[0].at};
}

static void *copy_of(arena *memory, const void *all, int count, size_t size)
{
    void *result = arena_take(memory, (size_t)count + 1, size);
    if (count > 0) {
        memcpy(result, all, (size_t)count * size);
    }
    return result;
}

/* The sums of efforts are made again of those parts that stay. */
static void drop_effect(mechanism *m, graph *g, int which)
{
    const vector none = vector_zero(g);
    const node zero = constant(g, 0.0);
    for (int f = 0; f < m->dof_count; f++) {
        m->efforts[f] = zero;
    }
    for (int i = 0; i < m->effort_part_count; i++) {
        effect_effort *part = &m->effort_parts[i];
        part->effort = part->effect == which ? zero : part->effort;
        m->efforts[part->dof] = add(g, m->efforts[part->dof], part->effort);
    }
    for (int i = 0; i < m->applied_force_count; i++) {
        if (m->applied_forces[i].drive < 0 && m->applied_forces[i].effect == which) {
            m->applied_forces[i].force = m->applied_forces[i].moment = none;
        }
    }
    for (int i = 0; i < m->effect_state_count; i++) {
        m->effect_states[i].next = m->effect_states[i].effect == which ? zero : m->effect_states[i].next;
    }
}

mechanism without_cause(const mechanism *m, graph *g, int which)
{
    arena *memory = g->memory;
    const node zero = constant(g, 0.0);
    const int at_joint = which - m->effect_count, spring = at_joint - m->segment_count;
    mechanism result = *m;
    if (at_joint < 0) {
        result.efforts = copy_of(memory, m->efforts, m->dof_count, sizeof *m->efforts);
        result.effort_parts = copy_of(memory, m->effort_parts, m->effort_part_count, sizeof *m->effort_parts);
        result.applied_forces = copy_of(memory, m->applied_forces, m->applied_force_count, sizeof *m->applied_forces);
        result.effect_states = copy_of(memory, m->effect_states, m->effect_state_count, sizeof *m->effect_states);
        drop_effect(&result, g, which);
    } else if (spring < 0) {
        result.segments = copy_of(memory, m->segments, m->segment_count, sizeof *m->segments);
        result.segments[at_joint].damping = result.segments[at_joint].spring = zero;
    } else if (spring < m->point_spring_count) {
        result.point_springs = copy_of(memory, m->point_springs, m->point_spring_count, sizeof *m->point_springs);
        result.point_springs[spring].stiffness = result.point_springs[spring].damping = zero;
    } else {
        result.alpha = result.beta = 0.0;
    }
    return result;
}
