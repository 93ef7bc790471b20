#include "tools/isoc/plant/accelerations.h"

#include "tools/isoc/graph/differentiate.h"

/* With the ground accelerated by -gravity, as the accelerations of the segments are. */
static vector specific_force(const plant *p, graph *g, const point_query *q)
{
    const kinematics *k = &p->d->k;
    const body_frame *frame = &p->m->bodies.frames[q->body];
    if (frame->segment == GROUND) {
        const vector up = vector_sub(g, vector_zero(g), p->m->forces.gravity);
        return q->in_body ? matrix_apply(g, matrix_transpose(frame->turn), up) : up;
    }
    const acceleration *now = &p->accelerations[frame->segment];
    const vector point = vector_add(g, matrix_apply(g, frame->turn, q->point), frame->offset);
    const vector moved = swing(g, k->motions[frame->segment].omega, now->alpha, point);
    const vector in_segment = vector_add(g, now->a, moved);
    return q->in_body ? matrix_apply(g, matrix_transpose(frame->turn), in_segment)
                      : outward_axes(k, frame->segment, GROUND, in_segment);
}

wrench reaction_of(plant *p, graph *g, int child, int loop)
{
    if (loop >= 0) {
        return closure_reaction(p->d, loop);
    }
    p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
    graph_section(g, "Reactions");
    return joint_reaction(p->d, p->accelerations, child);
}

static vector answer(plant *p, graph *g, const point_query *q, point_query_kind before)
{
    if (q->kind == QUERY_SPECIFIC_FORCE) {
        p->accelerations = p->accelerations == NULL ? reaction_accelerations(p->d) : p->accelerations;
        if (before != q->kind) {
            graph_section(g, "Specific forces");
        }
        return specific_force(p, g, q);
    }
    const wrench passed = reaction_of(p, g, q->body, q->closure);
    return q->kind == QUERY_FORCE ? passed.force : passed.moment;
}

void accelerations_resolve(plant *p, graph *g)
{
    const mechanism *m = p->m;
    node *answers = arena_take(g->memory, 3 * (size_t)m->queries.point_count + 1, sizeof *answers);
    point_query_kind before = QUERY_POSITION;
    for (int i = 0; i < m->queries.point_count; i++) {
        const bool is_query = asks_for_acceleration(m->queries.points[i].kind);
        const vector found = is_query ? answer(p, g, &m->queries.points[i], before) : vector_zero(g);
        before = is_query ? m->queries.points[i].kind : before;
        for (int n = 0; n < 3; n++) {
            answers[3 * i + n] = found.at[n];
        }
    }
    for (int i = 0; i < m->effects.memory_count && before != QUERY_POSITION; i++) {
        replace_leaves(g, &m->effects.memories[i].next, 1, OP_POINT_QUERY, answers);
        replace_leaves(g, &m->effects.memories[i].begin, 1, OP_POINT_QUERY, answers);
    }
    for (int i = 0; i < m->effects.state_count && before != QUERY_POSITION; i++) {
        replace_leaves(g, &m->effects.states[i].begin, 1, OP_POINT_QUERY, answers);
    }
    for (size_t i = 0; i < m->output_count && before != QUERY_POSITION; i++) {
        if (m->outputs[i].kind == OUTPUT_FORMULA) {
            replace_leaves(g, &m->outputs[i].formula, 1, OP_POINT_QUERY, answers);
        }
    }
}
