#include "tools/isoc/tree/point_query.h"

#include "tools/isoc/graph/differentiate.h"
#include "tools/isoc/tree/effective_inertia.h"

static vector answer(const kinematics *k, const point_query *p)
{
    graph *g = k->g;
    const body_frame *frame = &k->m->bodies.frames[p->body];
    const int at = frame->segment;
    const vector point = vector_add(g, matrix_apply(g, frame->turn, p->point), frame->offset);
    if (p->kind == QUERY_POSITION && !p->in_body) {
        return outward_point(k, at, GROUND, point);
    }
    vector in_segment = vector_zero(g);
    if (p->kind == QUERY_VELOCITY) {
        in_segment = point_velocity(k, at, point);
    } else if (p->kind == QUERY_SPIN) {
        in_segment = at == GROUND ? in_segment : k->motions[at].omega;
    } else {
        for (int i = 0; i < 3; i++) {
            in_segment.at[i] = frame->turn.at[i][p->kind - QUERY_X_AXIS];
        }
    }
    return p->in_body ? matrix_apply(g, matrix_transpose(frame->turn), in_segment)
                      : outward_axes(k, at, GROUND, in_segment);
}

/* What stands in the place of the leaves. */
typedef struct answers {
    const node *points;   /* three of each question */
    const node *inertias; /* NULL where none is asked for */
} answers;

static void replace(graph *g, node *roots, int count, const answers *by)
{
    replace_leaves(g, roots, (size_t)count, OP_POINT_QUERY, by->points);
    if (by->inertias != NULL) {
        replace_leaves(g, roots, (size_t)count, OP_INERTIA, by->inertias);
    }
}

void point_queries_resolve(graph *g, mechanism *m)
{
    const bool by_inertia = asks_for_inertia(g);
    bool any = m->queries.point_count > 0 || by_inertia;
    for (int i = 0; i < m->forces.applied_count; i++) {
        any = any || m->forces.applied[i].drive < 0;
    }
    if (!any) {
        return;
    }
    const kinematics k = kinematics_build(g, m);
    kinematics_velocities(&k);
    graph_section(g, "Points of effects, in the ground's frame");
    node *points = arena_take(g->memory, 3 * (size_t)m->queries.point_count + 1, sizeof *points);
    for (int i = 0; i < m->queries.point_count; i++) {
        const bool is_later = asks_for_acceleration(m->queries.points[i].kind);
        const vector a = is_later ? vector_zero(g) : answer(&k, &m->queries.points[i]);
        for (int n = 0; n < 3; n++) {
            points[3 * i + n] = is_later ? leaf(g, OP_POINT_QUERY, 3 * i + n) : a.at[n];
        }
    }
    const answers all = {points, by_inertia ? effective_inertias(g, m) : NULL};
    graph_section(g, "Effects");
    replace(g, m->effects.efforts, m->dof_count, &all);
    for (int i = 0; i < m->effects.count; i++) {
        replace(g, &m->effects.accounts[i].power, 1, &all);
        replace(g, &m->effects.accounts[i].stored, 1, &all);
        replace(g, &m->effects.accounts[i].loss, 1, &all);
        replace(g, &m->effects.accounts[i].work, 1, &all);
    }
    for (int i = 0; i < m->effects.derived_count; i++) {
        replace(g, &m->effects.derived[i].next, 1, &all);
    }
    for (int i = 0; i < m->effects.state_count; i++) {
        replace(g, &m->effects.states[i].next, 1, &all);
        replace(g, &m->effects.states[i].begin, 1, &all);
    }
    for (int i = 0; i < m->effects.memory_count; i++) {
        replace(g, &m->effects.memories[i].next, 1, &all);
        replace(g, &m->effects.memories[i].begin, 1, &all);
    }
    for (size_t i = 0; i < m->output_count; i++) {
        if (m->outputs[i].kind == OUTPUT_FORMULA) {
            replace(g, &m->outputs[i].formula, 1, &all);
        }
    }
    for (int i = 0; i < m->forces.applied_count; i++) {
        applied_force *f = &m->forces.applied[i];
        if (f->drive < 0) {
            replace(g, f->force.at, 3, &all);
            replace(g, f->moment.at, 3, &all);
            f->force = f->in_ground ? inward_axes(&k, GROUND, f->segment, f->force) : f->force;
            f->moment = f->in_ground ? inward_axes(&k, GROUND, f->segment, f->moment) : f->moment;
        }
    }
    for (int i = 0; i < m->effects.push_count; i++) {
        replace(g, &m->effects.pushes[i].effort, 1, &all);
    }
}
