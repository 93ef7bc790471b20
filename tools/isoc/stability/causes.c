#include "tools/isoc/stability/stability.h"

/* Effects, then joints, springs, and the stabilisation. */
int cause_count(const mechanism *m)
{
    return m->effects.count + m->segment_count + m->forces.spring_count + (m->closure_count > 0);
}

cause cause_of(const mechanism *m, int which)
{
    const int at_joint = which - m->effects.count, spring = at_joint - m->segment_count;
    if (which < 0) {
        return (cause){"mechanism", m->name, m->segments[0].at};
    }
    if (at_joint < 0) {
        return (cause){"effect", m->effects.names[which].text, m->effects.names[which].at};
    }
    if (spring < 0) {
        return (cause){"spring and damping of the joint", m->segments[at_joint].name, m->segments[at_joint].at};
    }
    if (spring < m->forces.spring_count) {
        return (cause){"spring", m->forces.springs[spring].name, m->forces.springs[spring].at};
    }
    return (cause){"stabilisation of the closure", m->closures[0].name, m->closures[0].at};
}

bool is_cause(const graph *g, const mechanism *m, int which)
{
    const int at_joint = which - m->effects.count;
    const segment *l = at_joint >= 0 && at_joint < m->segment_count ? &m->segments[at_joint] : NULL;
    return l == NULL || !is_zero(g, l->damping) || !is_zero(g, l->spring);
}

/* The sums of efforts are made again of those parts that stay. */
static void drop_effect(mechanism *m, graph *g, int which)
{
    const vector none = vector_zero(g);
    const node zero = constant(g, 0.0);
    m->effects.efforts = zero_nodes(g, (size_t)m->dof_count);
    FOR_ALL (effect_effort, part, m->effects.pushes, m->effects.push_count) {
        part->effort = part->effect == which ? zero : part->effort;
        m->effects.efforts[part->dof] = add(g, m->effects.efforts[part->dof], part->effort);
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        if (m->forces.applied[i].drive < 0 && m->forces.applied[i].effect == which) {
            m->forces.applied[i].force = m->forces.applied[i].moment = none;
        }
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        m->effects.states[i].next = m->effects.states[i].effect == which ? zero : m->effects.states[i].next;
    }
}

mechanism without_cause(const mechanism *m, graph *g, int which)
{
    arena *memory = g->memory;
    const node zero = constant(g, 0.0);
    const int at_joint = which - m->effects.count, spring = at_joint - m->segment_count;
    mechanism result = *m;
    if (at_joint < 0) {
        result.effects.pushes =
            list_copy(memory, m->effects.pushes, (size_t)m->effects.push_count, sizeof *m->effects.pushes);
        result.forces.applied =
            list_copy(memory, m->forces.applied, (size_t)m->forces.applied_count, sizeof *m->forces.applied);
        result.effects.states =
            list_copy(memory, m->effects.states, (size_t)m->effects.state_count, sizeof *m->effects.states);
        drop_effect(&result, g, which);
    } else if (spring < 0) {
        result.segments = list_copy(memory, m->segments, (size_t)m->segment_count, sizeof *m->segments);
        result.segments[at_joint].damping = result.segments[at_joint].spring = zero;
    } else if (spring < m->forces.spring_count) {
        result.forces.springs =
            list_copy(memory, m->forces.springs, (size_t)m->forces.spring_count, sizeof *m->forces.springs);
        result.forces.springs[spring].stiffness = result.forces.springs[spring].damping = zero;
    } else {
        result.drift.alpha = result.drift.beta = 0.0;
    }
    return result;
}
